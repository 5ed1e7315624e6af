// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/unseen_errors.h"

#include "fathom/base/parallel_for.h"
#include "fathom/simulate/coupled/coupled_prediction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace fathom {
namespace {

constexpr double kUnseenHorizon = 5.0;  // [s]
constexpr std::size_t kMostFolds = 4;

// A segment in `num` parts of the same length.
std::vector<CoupledSegment> Parts(const CoupledSegment& segment, std::size_t num) {
  std::vector<CoupledSegment> parts;
  const double length = (segment.time.back() - segment.time.front()) / static_cast<double>(num);
  for (const SampleWindow& range : WindowsOf(segment, length)) {
    CoupledSegment& part = parts.emplace_back();
    const auto cut = [](const auto& all, std::size_t begin, std::size_t end) {
      return std::vector(all.begin() + static_cast<std::ptrdiff_t>(begin),
                         all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    part.time = cut(segment.time, range.begin, range.end);
    part.velocity = cut(segment.velocity, range.begin, range.end);
    part.is_held_out = segment.is_held_out;
    if (segment.pose_time.empty()) continue;
    const auto first = segment.pose_time.begin();
    const auto from = std::lower_bound(first, segment.pose_time.end(), part.time.front()) - first;
    const auto to = std::upper_bound(first, segment.pose_time.end(), part.time.back()) - first;
    part.pose_time =
        cut(segment.pose_time, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    part.position =
        cut(segment.position, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    if (!segment.attitude.empty()) {
      part.attitude =
          cut(segment.attitude, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    }
  }
  return parts;
}

// The log with no segment of its motion.
CoupledData Emptied(const CoupledData& log) {
  CoupledData empty = log;
  empty.segments.clear();
  return empty;
}

void AddErrors(const std::vector<CoupledData>& logs,
               const CoupledPrediction& prediction,
               UnseenErrors* errors) {
  for (std::size_t k = 0; k < logs.size(); ++k) {
    for (std::size_t s = 0; s < logs[k].segments.size(); ++s) {
      const CoupledSegment& segment = logs[k].segments[s];
      for (const SampleWindow& window : WindowsOf(segment, kUnseenHorizon)) {
        Vector6 sum = Vector6::Zero();
        for (std::size_t i = window.begin; i < window.end; ++i) {
          const Vector6 miss = segment.velocity[i] - prediction.velocity[k][s][i];
          for (Eigen::Index row = 0; row < 6; ++row) {
            if (!std::isfinite(miss[row])) continue;
            sum[row] += std::abs(miss[row]);
            errors->motion[row] += std::abs(segment.velocity[i][row]);
          }
        }
        errors->error += sum;
        errors->by_window.push_back(sum / static_cast<double>(window.end - window.begin));
      }
    }
  }
}

}  // namespace

std::vector<Fold> FoldsOf(std::span<const CoupledData> logs) {
  const std::size_t num = logs.size() > 1 ? std::min(logs.size(), kMostFolds) : kMostFolds;
  std::vector<Fold> folds(num);
  for (std::size_t f = 0; f < num; ++f) {
    for (std::size_t k = 0; k < logs.size(); ++k) {
      folds[f].train.push_back(Emptied(logs[k]));
      folds[f].unseen.push_back(Emptied(logs[k]));
      for (const CoupledSegment& segment : logs[k].segments) {
        if (segment.is_held_out) continue;
        if (logs.size() > 1) {
          (k % num == f ? folds[f].unseen : folds[f].train).back().segments.push_back(segment);
          continue;
        }
        const std::vector<CoupledSegment> parts = Parts(segment, num);
        for (std::size_t p = 0; p < parts.size(); ++p) {
          (p % num == f ? folds[f].unseen : folds[f].train).back().segments.push_back(parts[p]);
        }
      }
    }
    const auto is_empty = [](const CoupledData& log) { return log.segments.empty(); };
    std::erase_if(folds[f].train, is_empty);
    std::erase_if(folds[f].unseen, is_empty);
  }
  std::erase_if(folds, [](const Fold& fold) { return fold.train.empty() || fold.unseen.empty(); });
  return folds;
}

UnseenErrors UnseenErrorsOf(const std::vector<Fold>& folds,
                            const MotionStructure& structure,
                            const CoupledSummary& fit,
                            CoupledFitOptions options) {
  UnseenErrors errors;
  options.start = fit.model;
  options.noise = fit.noise;
  options.learns_noise = false;
  std::vector<std::optional<CoupledPrediction>> predictions(folds.size());
  ParallelFor(static_cast<int>(folds.size()), [&](int f) {
    const auto at = static_cast<std::size_t>(f);
    const CoupledSummary part = FitCoupled(folds[at].train, structure, options);
    if (part.converged) {
      predictions[at] = PredictCoupled(part.model, folds[at].unseen, kUnseenHorizon);
    }
  });
  for (std::size_t f = 0; f < folds.size(); ++f) {
    if (!predictions[f]) return errors;
    AddErrors(folds[f].unseen, *predictions[f], &errors);
  }
  errors.is_known = !errors.by_window.empty();
  return errors;
}

UnseenErrors UnseenErrorsOf(const std::vector<Fold>& folds,
                            const std::vector<CoupledModel>& models) {
  UnseenErrors errors;
  for (std::size_t f = 0; f < folds.size(); ++f) {
    const auto prediction = PredictCoupled(models[f], folds[f].unseen, kUnseenHorizon);
    if (!prediction) return errors;
    AddErrors(folds[f].unseen, *prediction, &errors);
  }
  errors.is_known = !errors.by_window.empty();
  return errors;
}

std::array<double, 6> NmaeOf(const UnseenErrors& errors, const std::vector<Dof>& dofs) {
  std::array<double, 6> nmae;
  nmae.fill(std::numeric_limits<double>::quiet_NaN());
  if (!errors.is_known) return nmae;
  for (const Dof dof : dofs) {
    const auto row = Index(dof);
    nmae[static_cast<std::size_t>(row)] = errors.error[row] / errors.motion[row];
  }
  return nmae;
}

UnseenGain GainOf(const UnseenErrors& a, const UnseenErrors& b, const std::vector<Dof>& dofs) {
  const std::size_t n = a.by_window.size();
  Vector6 mean = Vector6::Zero();
  for (const Vector6& window : a.by_window) mean += window / static_cast<double>(n);
  double sum = 0.0, squares = 0.0;
  for (std::size_t w = 0; w < n; ++w) {
    double gain = 0.0;
    for (const Dof dof : dofs) {
      const auto row = Index(dof);
      if (mean[row] > 0.0) {
        gain += (a.by_window[w][row] - b.by_window[w][row]) / mean[row] /
                static_cast<double>(dofs.size());
      }
    }
    sum += gain;
    squares += gain * gain;
  }
  const double num = static_cast<double>(n);
  UnseenGain gain_of_all;
  gain_of_all.share = sum / num;
  const double variance =
      n > 1 ? (squares - num * gain_of_all.share * gain_of_all.share) / (num - 1.0) : 0.0;
  gain_of_all.in_errors = variance > 0.0 ? gain_of_all.share / std::sqrt(variance / num) : 0.0;
  return gain_of_all;
}

}  // namespace fathom
