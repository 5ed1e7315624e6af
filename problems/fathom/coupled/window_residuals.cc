// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/window_residuals.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace fathom {
namespace {

// The small turn, in the body frame, from `measured` to `simulated`.
Eigen::Vector3d TurnBetween(const Eigen::Quaterniond& measured, const Eigen::Vector4d& simulated) {
  Eigen::Quaterniond q = measured.conjugate() * Eigen::Quaterniond(simulated);
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const double sine = q.vec().norm();
  if (sine < 1e-9) return 2.0 * q.vec();
  return 2.0 * std::atan2(sine, q.w()) / sine * q.vec();
}

// Simulated less measured at the i-th sample of a window.
double ResidualAt(const CoupledWindow& window,
                  const FittedChannel& channel,
                  const CoupledOutputs& outputs,
                  std::size_t i) {
  const CoupledSegment& segment = *window.segment;
  switch (channel.kind) {
    case FittedChannel::Kind::kVelocity:
      return outputs.velocity[i][channel.row] -
             segment.velocity[window.samples.begin + i][channel.row];
    case FittedChannel::Kind::kTurn:
      return TurnBetween(segment.attitude[window.poses.begin + i],
                         outputs.pose[i].attitude)[channel.row - 3];
    case FittedChannel::Kind::kPosition:
      break;
  }
  return outputs.pose[i].position[channel.row] -
         segment.position[window.poses.begin + i][channel.row];
}

// The row of the outputs' sensitivities that is of a channel's i-th sample.
Eigen::Index SensitivityRow(const FittedChannel& channel, std::size_t i) {
  const auto first = 6 * static_cast<Eigen::Index>(i);
  switch (channel.kind) {
    case FittedChannel::Kind::kVelocity:
      return first + channel.row;
    case FittedChannel::Kind::kTurn:
      return first + channel.row - 3;
    case FittedChannel::Kind::kPosition:
      break;
  }
  return first + 3 + channel.row;
}

// Columns of what is free at the start among those of the outputs' sensitivities.
std::vector<Eigen::Index> StartColumns(const FreeStart& free, std::size_t num_entries) {
  std::vector<Eigen::Index> columns;
  auto column = static_cast<Eigen::Index>(num_entries);
  for (std::size_t i = 0; i < free.rows.size(); ++i) columns.push_back(column++);
  for (const bool turns : free.turns) {
    if (turns) columns.push_back(column);
    ++column;
  }
  return columns;
}

void AddDerivatives(const FittedChannel& channel,
                    const CoupledOutputs& outputs,
                    std::size_t first,
                    std::size_t num_entries,
                    const FreeStart& free,
                    WindowResiduals::Piece* piece) {
  const auto& sensitivity = channel.kind == FittedChannel::Kind::kVelocity
                                ? outputs.velocity_sensitivity
                                : outputs.pose_sensitivity;
  const std::vector<Eigen::Index> columns = StartColumns(free, num_entries);
  const auto num = static_cast<Eigen::Index>(num_entries);
  piece->rows.rightCols(free.size()).setZero();
  for (Eigen::Index i = 0; i < piece->rows.rows(); ++i) {
    const Eigen::Index row = SensitivityRow(channel, first + static_cast<std::size_t>(i));
    piece->rows.row(i).segment(1, num) = sensitivity.row(row).head(num);
    auto by_start = piece->rows.row(i).tail(free.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      by_start[static_cast<Eigen::Index>(k)] = sensitivity(row, columns[k]);
    }
    if (channel.kind == FittedChannel::Kind::kPosition) {
      by_start[free.size() - 3 + channel.row] = 1.0;
    }
  }
}

}  // namespace

std::vector<CoupledWindow> CoupledWindowsOf(std::span<const CoupledData> logs, double length) {
  std::vector<CoupledWindow> windows;
  for (const CoupledData& log : logs) {
    for (const CoupledSegment& segment : log.segments) {
      if (segment.is_held_out) continue;
      for (const SampleWindow& samples : WindowsOf(segment, length)) {
        const auto first = segment.pose_time.begin();
        const auto from =
            std::lower_bound(first, segment.pose_time.end(), segment.time[samples.begin]);
        const auto to =
            std::upper_bound(from, segment.pose_time.end(), segment.time[samples.end - 1]);
        windows.push_back(
            {&log,
             &segment,
             samples,
             {static_cast<std::size_t>(from - first), static_cast<std::size_t>(to - first)},
             MeasuredState(segment, samples.begin)});
      }
    }
  }
  return windows;
}

int FreeStart::size() const {
  const auto num_turns = std::count(turns.begin(), turns.end(), true);
  return static_cast<int>(rows.size()) + static_cast<int>(num_turns) + (position ? 3 : 0);
}

FreeStart FreeStartOf(std::span<const CoupledData> logs,
                      const std::vector<FittedChannel>& channels) {
  FreeStart free;
  for (const Dof dof : logs.front().dofs) {
    free.rows.push_back(Index(dof));
    // A tilt that is not measured shows in the rates by the righting moment.
    if (dof == Dof::kRoll || dof == Dof::kPitch)
      free.turns[static_cast<std::size_t>(Index(dof) - 3)] = true;
  }
  for (const FittedChannel& channel : channels) {
    if (channel.kind == FittedChannel::Kind::kTurn)
      free.turns[static_cast<std::size_t>(channel.row - 3)] = true;
    if (channel.kind == FittedChannel::Kind::kPosition) free.position = true;
  }
  return free;
}

CoupledState Moved(const CoupledState& start, const FreeStart& free, const Eigen::VectorXd& step) {
  CoupledState moved = start;
  Eigen::Index at = 0;
  for (const int row : free.rows) moved.nu[row] += step[at++];
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (free.turns[static_cast<std::size_t>(axis)]) turn[axis] = step[at++];
  }
  const double angle = turn.norm();
  if (angle > 0.0) {
    const Eigen::Quaterniond by(Eigen::AngleAxisd(angle, turn / angle));
    moved.attitude = (Eigen::Quaterniond(start.attitude) * by).normalized().coeffs();
  }
  if (free.position) moved.position += step.segment<3>(at);
  return moved;
}

bool ResidualsOf(const CoupledWindow& window,
                 const CoupledModel& model,
                 const CoupledState& start,
                 std::span<const FreeEntry> entries,
                 const std::vector<FittedChannel>& channels,
                 const FreeStart& free,
                 bool with_derivatives,
                 WindowResiduals* residuals) {
  const CoupledSegment& segment = *window.segment;
  const auto cut = [](const std::vector<double>& time, const SampleWindow& range) {
    return std::vector<double>(time.begin() + static_cast<std::ptrdiff_t>(range.begin),
                               time.begin() + static_cast<std::ptrdiff_t>(range.end));
  };
  const auto is_of_velocity = [](const FittedChannel& channel) {
    return channel.kind == FittedChannel::Kind::kVelocity;
  };
  CoupledStamps stamps;
  stamps.start = segment.time[window.samples.begin];
  if (std::any_of(channels.begin(), channels.end(), is_of_velocity)) {
    stamps.velocity = cut(segment.time, window.samples);
  }
  if (!std::all_of(channels.begin(), channels.end(), is_of_velocity)) {
    stamps.pose = cut(segment.pose_time, window.poses);
  }
  thread_local CoupledOutputs outputs;  // megabytes, for many windows of the same size
  const bool runs =
      with_derivatives
          ? RunCoupledWithSensitivities(model, entries, window.log->inputs, start, stamps, &outputs)
          : RunCoupled(model, window.log->inputs, start, stamps, &outputs);
  if (!runs) return false;
  const Eigen::Index num_columns =
      with_derivatives ? 1 + static_cast<Eigen::Index>(entries.size()) + free.size() : 1;
  std::size_t num_pieces = 0;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::vector<double>& time = is_of_velocity(channels[c]) ? stamps.velocity : stamps.pose;
    std::vector<double> residual(time.size());
    for (std::size_t i = 0; i < time.size(); ++i) {
      residual[i] = ResidualAt(window, channels[c], outputs, i);
    }
    // What is not known ends a piece.
    const auto is_known = [](double value) { return std::isfinite(value); };
    for (auto begin = residual.begin(); begin != residual.end();) {
      begin = std::find_if(begin, residual.end(), is_known);
      const auto end = std::find_if_not(begin, residual.end(), is_known);
      if (begin == end) break;
      if (num_pieces == residuals->pieces.size()) residuals->pieces.emplace_back();
      WindowResiduals::Piece& piece = residuals->pieces[num_pieces++];
      const auto first = static_cast<std::size_t>(begin - residual.begin());
      piece.channel = c;
      piece.time.assign(time.begin() + (begin - residual.begin()),
                        time.begin() + (end - residual.begin()));
      piece.rows.resize(end - begin, num_columns);
      piece.rows.col(0) = Eigen::Map<const Eigen::VectorXd>(&*begin, end - begin);
      if (with_derivatives) {
        AddDerivatives(channels[c], outputs, first, entries.size(), free, &piece);
      }
      begin = end;
    }
  }
  residuals->pieces.resize(num_pieces);
  return true;
}

}  // namespace fathom
