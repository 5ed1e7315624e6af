// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/parameter_covariance.h"

#include "fathom/base/median.h"
#include "fathom/output_error/noise_colour.h"
#include "fathom/output_error/reduced_normal.h"
#include "fathom/output_error/signatures.h"
#include "fathom/signal/split_at_gaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr size_t kStretch = 4096;  // samples simulated at once: they fit into the cache

using Matrix = Eigen::MatrixXd;
using Pieces = std::vector<SampleRange>;

// Without a missing sample inside: the autoregression counts samples, not seconds.
Pieces UnbrokenPieces(const std::vector<double>& time) {
  return SplitAtGaps(time, {}, 0, 1.8 * MedianStep(time));
}

// The optimum that the evidence is about; as in EvidenceAt().
struct Optimum {
  std::span<const UncoupledModel<double>> models;
  std::span<const Segment> segments;
  std::span<const InitialState> initial_states;
  FittedOutput output;
  double sigma;
  double huber_k;
};

struct SimulatedRun {
  Eigen::VectorXd output;    // simulated; empty where rows are whitened
  Eigen::VectorXd residual;  // in standard deviations
};

// Simulated segment by segment, a stretch at a time so that memory does not grow with the log.
class SimulatedRows {
 public:
  explicit SimulatedRows(const Optimum& at) : at_(at) {}

  size_t num_segments() const { return at_.segments.size(); }
  int state_size() const { return StateSize(at_.output); }
  double huber_k() const { return at_.huber_k; }
  Pieces PiecesOf(size_t s) const { return UnbrokenPieces(at_.segments[s].time); }

  // Of the samples of segment `s`. Nothing if the simulation diverges.
  std::optional<SimulatedRun> Run(size_t s) const;

  // Calls visit(J, residual, is_end), as in Samples, for consecutive samples of an unbroken piece
  // of segment `s`. `is_end` tells that the piece ends. False if the simulation diverges.
  template <typename Visit>
  bool VisitRows(size_t s, const Pieces& pieces, Visit visit) const;

 private:
  const Optimum& at_;
};

std::optional<SimulatedRun> SimulatedRows::Run(size_t s) const {
  const Segment& segment = at_.segments[s];
  const bool is_velocity = at_.output == FittedOutput::kVelocity;
  std::vector<double> v(segment.time.size()), x(is_velocity ? 0 : v.size());
  const Simulation simulation(segment.command, segment.time);
  if (!simulation.Run(at_.models[s], at_.initial_states[s], v, x)) return std::nullopt;
  const std::vector<double>& simulated = is_velocity ? v : x;
  const std::vector<double>& measured = is_velocity ? segment.velocity : segment.position;
  using Column = Eigen::Map<const Eigen::VectorXd>;
  const Column output(simulated.data(), std::ssize(simulated));
  return SimulatedRun{output, (output - Column(measured.data(), std::ssize(measured))) / at_.sigma};
}

template <typename Visit>
bool SimulatedRows::VisitRows(size_t s, const Pieces& pieces, Visit visit) const {
  const Segment& segment = at_.segments[s];
  StretchStart start = SegmentStart(at_.initial_states[s]);
  Stretch stretch;
  Samples samples;
  auto piece = pieces.begin();
  for (size_t begin = 0; begin < segment.time.size(); begin += kStretch) {
    // The next stretch's first sample is simulated as well: that is where it starts.
    const size_t end = std::min(begin + kStretch, segment.time.size());
    const size_t num_outputs = std::min(end + 1, segment.time.size()) - begin;
    const auto time = std::span(segment.time).subspan(begin, num_outputs);
    if (!SimulateStretch(at_.models[s], segment.command, time, at_.output, &start, &stretch)) {
      return false;
    }
    FillSamples(at_.models[s], segment, begin, end, at_.output, at_.sigma, stretch, &samples);
    for (size_t first = begin; first < end;) {
      const size_t last = std::min(end, piece->end);
      const auto from = static_cast<Eigen::Index>(first - begin);
      const auto count = static_cast<Eigen::Index>(last - first);
      visit(samples.J.middleRows(from, count),
            samples.residual.segment(from, count),
            last == piece->end);
      if (last == piece->end) ++piece;
      first = last;
    }
  }
  return true;
}

// Held in memory, whitened: a segment is one piece, and plain squares count.
class WhitenedRows {
 public:
  explicit WhitenedRows(std::span<const Samples> segments) : segments_(segments) {}

  size_t num_segments() const { return segments_.size(); }
  int state_size() const { return static_cast<int>(segments_.front().J.cols()) - kSharedColumns; }
  double huber_k() const { return std::numeric_limits<double>::infinity(); }
  Pieces PiecesOf(size_t s) const {
    return {{.begin = 0, .end = static_cast<size_t>(segments_[s].residual.size())}};
  }

  std::optional<SimulatedRun> Run(size_t s) const {
    return SimulatedRun{{}, segments_[s].residual};
  }

  template <typename Visit>
  bool VisitRows(size_t s, const Pieces& /*pieces*/, Visit visit) const {
    visit(segments_[s].J, segments_[s].residual, true);
    return true;
  }

 private:
  std::span<const Samples> segments_;
};

// The residuals, which tell their colour.
struct Residuals {
  std::vector<Pieces> pieces;                  // by segment
  std::vector<std::vector<double>> influence;  // psi(r), by piece: r where it is small, k beyond
  size_t bin_size = 1;                         // of samples that vary little in what is simulated
};

// Nothing if a simulation diverges.
template <typename Rows>
std::optional<Residuals> ResidualsOf(const Rows& rows) {
  Residuals residuals;
  BinLosses losses;
  for (size_t s = 0; s < rows.num_segments(); ++s) {
    const auto run = rows.Run(s);
    if (!run) return std::nullopt;
    if (run->output.size() > 0) losses.Add(run->output);
    for (const SampleRange& piece : residuals.pieces.emplace_back(rows.PiecesOf(s))) {
      std::vector<double>& psi = residuals.influence.emplace_back();
      psi.reserve(piece.size());
      for (size_t i = piece.begin; i < piece.end; ++i) {
        const double r = run->residual[static_cast<Eigen::Index>(i)];
        psi.push_back(std::clamp(r, -rows.huber_k(), rows.huber_k()));
      }
    }
  }
  residuals.bin_size = losses.LargestSize();
  return residuals;
}

// What residuals of a colour do to the parameters.
template <typename Rows>
ReducedNormal NormalOf(const Rows& rows,
                       const std::vector<Pieces>& pieces,
                       const Colour& colour,
                       const OffsetSharing& offsets) {
  ReducedNormal normal(static_cast<Eigen::Index>(offsets.Count()));
  const int num_columns = kSharedColumns + rows.state_size();
  ColouredGram coloured(colour.noise, num_columns);
  BinnedRows bins(colour.bin_size, num_columns);
  for (size_t s = 0; s < rows.num_segments(); ++s) {
    Matrix A = Matrix::Zero(num_columns, num_columns), B = A;
    const auto visit = [&](const auto& J, const auto& residual, bool is_end) {
      const Eigen::VectorXd is_small = (residual.abs() <= rows.huber_k()).template cast<double>();
      A += J.transpose() * is_small.asDiagonal() * J;
      bins.Add(J, is_end);
      coloured.Add(bins.full());
      if (is_end) B += coloured.EndPiece();
    };
    rows.VisitRows(s, pieces[s], visit);
    AddSegment(A, B, static_cast<Eigen::Index>(offsets.At(s)), &normal);
  }
  return normal;
}

void DescribeParameters(const ReducedNormal& normal, double freedom, ParameterEvidence* evidence) {
  const SolvedNormal alone = Solve(normal, false);
  evidence->covariance = freedom * alone.covariance;
  evidence->offset_variance = freedom * alone.offset_variance;
  evidence->share = alone.share;
  evidence->condition_number = alone.condition_number;
  const SolvedNormal with_offset = Solve(normal, true);
  evidence->covariance_with_time_offset = freedom * with_offset.covariance;
  if (std::isfinite(alone.condition_number) && !std::isfinite(with_offset.condition_number)) {
    evidence->covariance_with_time_offset.setConstant(std::numeric_limits<double>::infinity());
  }
  evidence->share_with_time_offset = with_offset.share;
  evidence->change_per_second_of_offset = alone.change_per_second_of_offset;
}

// First the residuals and their colour, then what the colour does to the parameters: simulating
// twice is cheaper than keeping the signatures of a long log.
template <typename Rows>
ParameterEvidence EvidenceOfRows(const Rows& rows, const OffsetSharing& offsets) {
  ParameterEvidence evidence;
  evidence.offset_variance = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(offsets.Count()),
                                                       ParameterEvidence::kNotComputed);
  std::optional<Residuals> residuals = ResidualsOf(rows);
  if (!residuals) return evidence;
  const Colour of_samples = ColourOfSamples(residuals->influence);
  evidence.noise_correlation = of_samples.sums.NeighbourCorrelation();
  evidence.noise = of_samples.noise;
  const Colour colour = SlowerColour(of_samples, residuals->influence, residuals->bin_size);
  const ReducedNormal normal = NormalOf(rows, residuals->pieces, colour, offsets);
  const double num_unknowns = static_cast<double>(kBuoyancy + normal.num_offsets()) +
                              static_cast<double>(rows.num_segments()) * rows.state_size();
  DescribeParameters(normal, FreedomFactor(colour, num_unknowns), &evidence);
  return evidence;
}

}  // namespace

ParameterEvidence EvidenceAt(std::span<const UncoupledModel<double>> models,
                             std::span<const Segment> segments,
                             std::span<const InitialState> initial_states,
                             FittedOutput output,
                             double sigma,
                             double huber_k,
                             const OffsetSharing& offsets) {
  const Optimum at = {models, segments, initial_states, output, sigma, huber_k};
  return EvidenceOfRows(SimulatedRows(at), offsets);
}

ParameterEvidence EvidenceOf(std::span<const Samples> whitened, const OffsetSharing& offsets) {
  return EvidenceOfRows(WhitenedRows(whitened), offsets);
}

}  // namespace fathom
