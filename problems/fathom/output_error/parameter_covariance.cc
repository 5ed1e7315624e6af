// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/parameter_covariance.h"

#include "fathom/base/median.h"
#include "fathom/output_error/reduced_normal.h"
#include "fathom/output_error/signatures.h"
#include "fathom/signal/split_at_gaps.h"

#include <algorithm>
#include <array>
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

struct FreeRun {
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
  std::optional<FreeRun> Run(size_t s) const;

  // Calls visit(J, residual, is_end), as in Samples, for consecutive samples of an unbroken piece
  // of segment `s`. `is_end` tells that the piece ends. False if the simulation diverges.
  template <typename Visit>
  bool VisitRows(size_t s, const Pieces& pieces, Visit visit) const;

 private:
  const Optimum& at_;
};

std::optional<FreeRun> SimulatedRows::Run(size_t s) const {
  const Segment& segment = at_.segments[s];
  const bool is_velocity = at_.output == FittedOutput::kVelocity;
  std::vector<double> v(segment.time.size()), x(is_velocity ? 0 : v.size());
  const Simulation simulation(segment.command, segment.time);
  if (!simulation.Run(at_.models[s], at_.initial_states[s], v, x)) return std::nullopt;
  const std::vector<double>& simulated = is_velocity ? v : x;
  const std::vector<double>& measured = is_velocity ? segment.velocity : segment.position;
  using Column = Eigen::Map<const Eigen::VectorXd>;
  const Column output(simulated.data(), std::ssize(simulated));
  return FreeRun{output, (output - Column(measured.data(), std::ssize(measured))) / at_.sigma};
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

  std::optional<FreeRun> Run(size_t s) const { return FreeRun{{}, segments_[s].residual}; }

  template <typename Visit>
  bool VisitRows(size_t s, const Pieces& /*pieces*/, Visit visit) const {
    visit(segments_[s].J, segments_[s].residual, true);
    return true;
  }

 private:
  std::span<const Samples> segments_;
};

// The fit bends the residuals towards zero by as many degrees of freedom as it has unknowns, and
// coloured residuals have fewer to give: the effective number of samples is n times the variance of
// a white residual's mean over that of this one.
double FreedomFactor(const Autoregression& noise,
                     double sum_of_squares,
                     double num_samples,
                     double num_unknowns) {
  double sum = 1.0;
  for (const double phi : noise.coefficients) sum -= phi;
  const double variance = sum_of_squares / num_samples;
  const double shrink = std::min(1.0, variance * sum * sum / noise.innovation_variance);
  const double num_effective = std::max(num_samples * shrink, 2.0 * num_unknowns);
  return num_effective / (num_effective - num_unknowns);
}

// How many samples go into a mean, at most.
constexpr std::array<size_t, 8> kBinSizes = {1, 2, 3, 4, 6, 8, 12, 16};
constexpr double kFewestBins = 300.0;
constexpr double kMostLost = 0.005;  // of the variance of the output, by means of bins

// What means of bins lose of an output's variance.
struct LostToBins {
  double all = 0.0;
  std::array<double, kBinSizes.size()> lost = {};

  void Add(const Eigen::VectorXd& output) {
    const Eigen::ArrayXd about = output.array() - output.mean();
    all += about.square().sum();
    for (size_t k = 0; k < kBinSizes.size(); ++k) {
      const auto size = static_cast<Eigen::Index>(kBinSizes[k]);
      for (Eigen::Index i = 0; i < about.size(); i += size) {
        const auto bin = about.segment(i, std::min(size, about.size() - i));
        lost[k] += (bin - bin.mean()).square().sum();
      }
    }
  }

  size_t LargestSize(double num_samples) const {
    size_t largest = 1;
    for (size_t k = 0; k < kBinSizes.size(); ++k) {
      const bool are_many = num_samples >= kFewestBins * static_cast<double>(kBinSizes[k]);
      if (are_many && lost[k] <= kMostLost * all) largest = kBinSizes[k];
    }
    return largest;
  }
};

// The residuals, which tell their colour.
struct Residuals {
  std::vector<Pieces> pieces;                  // by segment
  std::vector<std::vector<double>> influence;  // psi(r), by piece: r where it is small, k beyond
  size_t bin_size = 1;                         // of samples that vary little in what is simulated
};

// Means of so many values, the last of fewer.
std::vector<std::vector<double>> Binned(const std::vector<std::vector<double>>& pieces,
                                        size_t size) {
  std::vector<std::vector<double>> binned;
  for (const std::vector<double>& piece : pieces) {
    std::vector<double>& means = binned.emplace_back();
    for (size_t i = 0; i < piece.size(); i += size) {
      const size_t end = std::min(i + size, piece.size());
      double sum = 0.0;
      for (size_t j = i; j < end; ++j) sum += piece[j];
      means.push_back(sum / static_cast<double>(end - i));
    }
  }
  return binned;
}

// Nothing if a simulation diverges.
template <typename Rows>
std::optional<Residuals> ResidualsOf(const Rows& rows) {
  Residuals residuals;
  LostToBins lost;
  double num_samples = 0.0;
  for (size_t s = 0; s < rows.num_segments(); ++s) {
    const auto run = rows.Run(s);
    if (!run) return std::nullopt;
    if (run->output.size() > 0) lost.Add(run->output);
    num_samples += static_cast<double>(run->residual.size());
    for (const SampleRange& piece : residuals.pieces.emplace_back(rows.PiecesOf(s))) {
      std::vector<double>& psi = residuals.influence.emplace_back();
      psi.reserve(piece.size());
      for (size_t i = piece.begin; i < piece.end; ++i) {
        const double r = run->residual[static_cast<Eigen::Index>(i)];
        psi.push_back(std::clamp(r, -rows.huber_k(), rows.huber_k()));
      }
    }
  }
  if (lost.all > 0.0) residuals.bin_size = lost.LargestSize(num_samples);
  return residuals;
}

// Sums over the pieces of psi(r).
struct InfluenceSums {
  double num_samples = 0.0;
  double power = 0.0;    // of squares
  double product = 0.0;  // of neighbours
};

InfluenceSums SumsOf(const std::vector<std::vector<double>>& influence) {
  InfluenceSums sums;
  for (const auto& psi : influence) {
    sums.num_samples += static_cast<double>(psi.size());
    for (size_t i = 0; i < psi.size(); ++i) {
      sums.power += psi[i] * psi[i];
      if (i > 0) sums.product += psi[i] * psi[i - 1];
    }
  }
  return sums;
}

int MaxOrder(double num_samples) {
  return static_cast<int>(std::min({60.0, 10.0 * std::log10(num_samples), num_samples / 10.0}));
}

// The colour of means over bins of some samples.
struct Colour {
  size_t bin_size;
  Autoregression noise;
  InfluenceSums sums;
};

// What the variance of a mean over a long time tends to, times its number of samples.
double LongRunVariance(const Colour& colour) {
  double sum = 1.0;
  for (const double phi : colour.noise.coefficients) sum -= phi;
  return static_cast<double>(colour.bin_size) * colour.noise.innovation_variance / (sum * sum);
}

// That of the samples, or of means over bins where these have more of what is slow: among the
// sensor's noise AIC takes little of it for none.
Colour SlowerColour(const Autoregression& of_samples,
                    const InfluenceSums& sums,
                    const std::vector<std::vector<double>>& influence,
                    size_t bin_size) {
  Colour fine = {1, of_samples, sums};
  if (bin_size == 1) return fine;
  std::vector<std::vector<double>> means = Binned(influence, bin_size);
  const InfluenceSums of_means = SumsOf(means);
  Colour coarse = {
      bin_size, FitAutoregression(std::move(means), MaxOrder(of_means.num_samples)), of_means};
  return LongRunVariance(coarse) > LongRunVariance(fine) ? coarse : fine;
}

// Sums of the rows of each bin, as they arrive.
class BinnedRows {
 public:
  BinnedRows(size_t size, int num_columns)
      : size_(static_cast<Eigen::Index>(size)), open_(Eigen::RowVectorXd::Zero(num_columns)) {}

  void Add(const Eigen::Ref<const Matrix>& rows, bool is_end) {
    full_.resize((num_open_ + rows.rows()) / size_ + 1, rows.cols());
    Eigen::Index num_full = 0;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      open_ += rows.row(i);
      const bool is_last = is_end && i + 1 == rows.rows();
      if (++num_open_ < size_ && !is_last) continue;
      full_.row(num_full++) = open_;
      open_.setZero();
      num_open_ = 0;
    }
    full_.conservativeResize(num_full, Eigen::NoChange);
  }

  // Those that the last rows filled.
  const Matrix& full() const { return full_; }

 private:
  const Eigen::Index size_;
  Eigen::Index num_open_ = 0;
  Eigen::RowVectorXd open_;
  Matrix full_;
};

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
  const InfluenceSums sums = SumsOf(residuals->influence);
  evidence.noise_correlation = sums.product / sums.power;
  evidence.noise = FitAutoregression(residuals->influence, MaxOrder(sums.num_samples));
  const Colour colour =
      SlowerColour(evidence.noise, sums, residuals->influence, residuals->bin_size);
  const ReducedNormal normal = NormalOf(rows, residuals->pieces, colour, offsets);
  const double num_unknowns = static_cast<double>(kBuoyancy + normal.num_offsets()) +
                              static_cast<double>(rows.num_segments()) * rows.state_size();
  const double freedom =
      FreedomFactor(colour.noise, colour.sums.power, colour.sums.num_samples, num_unknowns);
  DescribeParameters(normal, freedom, &evidence);
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
