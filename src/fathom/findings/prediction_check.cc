// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/prediction_check.h"

#include "fathom/base/interval95.h"
#include "fathom/base/short_number.h"
#include "fathom/findings/batch_means.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLeastSlope = 2.0 / 3.0;
constexpr double kMostSlope = 3.0 / 2.0;
constexpr double kMostShare = 0.5;
constexpr double kErrors = 3.0;  // standard errors

// What counts in the figures of a prediction, each about its mean.
struct Speeds {
  Eigen::ArrayXd measured, predicted;
  double noise = 0.0;  // variance of the sensor's
};

Speeds SpeedsOf(const LogPrediction& prediction) {
  std::vector<double> measured, predicted;
  double sum_of_bends = 0.0;
  double num_bends = 0.0;
  for (std::size_t k = 0; k < prediction.segments.size(); ++k) {
    if (prediction.parts[k] == LogPart::kOutside) continue;
    const std::vector<double>& v = prediction.segments[k].velocity;
    measured.insert(measured.end(), v.begin(), v.end());
    predicted.insert(predicted.end(), prediction.velocity[k].begin(), prediction.velocity[k].end());
    for (std::size_t i = 1; i + 1 < v.size(); ++i, num_bends += 1.0) {
      const double bend = v[i + 1] - 2.0 * v[i] + v[i - 1];
      sum_of_bends += bend * bend;
    }
  }
  const auto about_mean = [](const std::vector<double>& values) -> Eigen::ArrayXd {
    const Eigen::Map<const Eigen::ArrayXd> all(values.data(),
                                               static_cast<Eigen::Index>(values.size()));
    return all - all.mean();
  };
  if (num_bends == 0.0) return {};
  // 1 + 4 + 1 variances of white noise; more than the noise where the motion bends.
  return {about_mean(measured), about_mean(predicted), sum_of_bends / num_bends / 6.0};
}

}  // namespace

std::optional<Finding> CheckPrediction(const std::optional<LogPrediction>& prediction, Dof dof) {
  if (!prediction) {
    return Finding{Severity::kWarning,
                   "prediction",
                   "The prediction of this log diverges or is too stiff. Log and model may differ "
                   "in a unit, a sign or the vehicle."};
  }
  const auto [v, p, noise] = SpeedsOf(*prediction);
  if (v.size() == 0) return std::nullopt;
  const double motion = v.square().mean() - noise;
  const double predicted_motion = p.square().mean();
  if (!(motion > noise && predicted_motion > 0.0)) return std::nullopt;

  const double slope = (p * v).mean() / predicted_motion;
  const double slope_error = ErrorOfMean(p * v - slope * p.square()) / predicted_motion;
  const bool is_of_another_size =
      slope + kErrors * slope_error < kLeastSlope || slope - kErrors * slope_error > kMostSlope;

  const Eigen::ArrayXd missed = (v - p).square() - noise;
  const Eigen::ArrayXd excess = missed - kMostShare * (v.square() - noise);
  const bool misses_most = excess.mean() > kErrors * ErrorOfMean(excess);
  if (!is_of_another_size && !misses_most) return std::nullopt;
  return Finding{Severity::kWarning,
                 "prediction",
                 fmt::format("The prediction does not follow the {} of this log: the measured "
                             "one is {:.3g} ± {} times the predicted one, and the prediction "
                             "misses {} times its variance, sensor noise left out. Log and "
                             "model may differ in a unit, a sign or the vehicle.",
                             IsAngular(dof) ? "rate" : "speed",
                             slope,
                             ShortNumber(kStdsOf95 * slope_error, 1),
                             ShortNumber(missed.mean() / motion, 2))};
}

}  // namespace fathom
