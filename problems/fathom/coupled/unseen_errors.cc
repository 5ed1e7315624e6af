// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/unseen_errors.h"

#include "fathom/base/parallel_for.h"
#include "fathom/coupled/fold_fits.h"
#include "fathom/simulate/coupled/coupled_prediction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace fathom {
namespace {

constexpr double kUnseenHorizon = 5.0;  // [s]

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

UnseenErrors UnseenErrorsOf(const std::vector<Fold>& folds,
                            const MotionStructure& structure,
                            const CoupledSummary& fit,
                            const CoupledFitOptions& options) {
  UnseenErrors errors;
  const std::vector<std::optional<CoupledModel>> models = FitFolds(folds, structure, fit, options);
  std::vector<std::optional<CoupledPrediction>> predictions(folds.size());
  ParallelFor(static_cast<int>(folds.size()), [&](int f) {
    const auto at = static_cast<std::size_t>(f);
    if (models[at]) {
      predictions[at] = PredictCoupled(*models[at], folds[at].unseen, kUnseenHorizon);
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
