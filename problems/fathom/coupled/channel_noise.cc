// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/channel_noise.h"

#include "fathom/base/robust_std.h"
#include "fathom/signal/filters/autoregression.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr int kMostOrder = 12;            // of a channel's noise
constexpr double kQuietest = 1e-4;        // the least noise, of what a channel shows in a second
constexpr double kQuietestOfAll = 1e-12;  // [unit of the channel]
constexpr double kWild = 5.0;             // standard deviations

using ChannelPieces = std::vector<std::vector<double>>;  // unbroken runs of samples

ChannelPieces PiecesOf(const std::vector<WindowResiduals>& residuals, std::size_t channel) {
  ChannelPieces pieces;
  for (const WindowResiduals& window : residuals) {
    for (const WindowResiduals::Piece& piece : window.pieces) {
      if (piece.channel == channel) {
        const Eigen::VectorXd residual = piece.rows.col(0);
        pieces.emplace_back(residual.data(), residual.data() + residual.size());
      }
    }
  }
  return pieces;
}

// A robust standard deviation about 0.
double SpreadOf(const ChannelPieces& pieces) {
  std::vector<double> sizes;
  for (const auto& piece : pieces) {
    for (const double value : piece) sizes.push_back(std::abs(value));
  }
  return sizes.empty() ? 1.0 : RobustStd(std::move(sizes));
}

ChannelPieces WithoutWildOnes(ChannelPieces pieces, double std) {
  for (auto& piece : pieces) {
    for (double& value : piece) value = std::clamp(value, -kWild * std, kWild * std);
  }
  return pieces;
}

Autoregression WhiteNoise(double std) { return {{}, std * std}; }

// White where no colour can be learned.
Autoregression ColourOf(ChannelPieces pieces, double std) {
  Autoregression colour = FitAutoregression(WithoutWildOnes(std::move(pieces), std), kMostOrder);
  return colour.innovation_variance > 0.0 ? colour : WhiteNoise(std);
}

// The mean square of each measured velocity [m^2/s^2] or [rad^2/s^2], 0 where none is.
Vector6 MeanSquareVelocity(const std::vector<CoupledWindow>& windows) {
  Vector6 squares = Vector6::Zero(), num = Vector6::Zero();
  for (const CoupledWindow& window : windows) {
    for (std::size_t i = window.samples.begin; i < window.samples.end; ++i) {
      const Vector6& velocity = window.segment->velocity[i];
      for (Eigen::Index row = 0; row < 6; ++row) {
        if (!std::isfinite(velocity[row])) continue;
        squares[row] += velocity[row] * velocity[row];
        num[row] += 1.0;
      }
    }
  }
  return squares.cwiseQuotient(num.cwiseMax(1.0));
}

}  // namespace

std::vector<double> QuietestSensors(const WindowProblem& problem) {
  const Vector6 square = MeanSquareVelocity(problem.windows);
  std::vector<double> quietest;
  for (const FittedChannel& channel : problem.channels) {
    const bool is_position = channel.kind == FittedChannel::Kind::kPosition;
    const double speed = std::sqrt(is_position ? square.head<3>().sum() : square[channel.row]);
    quietest.push_back(std::max(kQuietest * speed, kQuietestOfAll));
  }
  return quietest;
}

std::vector<ChannelNoise> WhiteNoiseOf(const std::vector<WindowResiduals>& residuals,
                                       const std::vector<FittedChannel>& channels,
                                       const std::vector<double>& quietest) {
  std::vector<ChannelNoise> noise;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const double std = std::max(SpreadOf(PiecesOf(residuals, c)), quietest[c]);
    noise.push_back({channels[c], RowWhitener(WhiteNoise(std))});
  }
  return noise;
}

std::vector<ChannelNoise> ColouredNoiseOf(const std::vector<WindowResiduals>& residuals,
                                          const std::vector<FittedChannel>& channels,
                                          const std::vector<double>& quietest) {
  std::vector<ChannelNoise> noise;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    ChannelPieces pieces = PiecesOf(residuals, c);
    const double spread = SpreadOf(pieces);
    const double std = std::max(spread, quietest[c]);
    const Autoregression colour =
        spread > quietest[c] ? ColourOf(std::move(pieces), std) : WhiteNoise(std);
    noise.push_back({channels[c], RowWhitener(colour)});
  }
  return noise;
}

bool IsOf(const std::vector<ChannelNoise>& noise, const std::vector<FittedChannel>& channels) {
  return std::ranges::equal(noise, channels, {}, &ChannelNoise::channel);
}

std::vector<ChannelWeight> WeightsOf(const std::vector<ChannelNoise>& noise, double huber_k) {
  std::vector<ChannelWeight> weights;
  for (const ChannelNoise& channel : noise) weights.push_back({channel.whitener, huber_k});
  return weights;
}

}  // namespace fathom
