// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/remains_fold.h"

#include "fathom/identification/identification_text.h"
#include "fathom/identification/parameter_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kOutsideByChance = 0.05;
constexpr double kMostByChance = 1.5;  // times the power of white noise in a band
constexpr const char* kWhiteNoise = "white noise, 95 %";

// The largest share of so many lags that white noise leaves outside, three standard deviations up.
double MostOutsideByChance(std::size_t num_lags) {
  const double variance = kOutsideByChance * (1.0 - kOutsideByChance);
  return kOutsideByChance + 3.0 * std::sqrt(variance / static_cast<double>(num_lags));
}

// The lag nearest to a second.
std::size_t LagOfASecond(const Autocorrelation& autocorrelation) {
  const auto nearest = std::ranges::min_element(
      autocorrelation.lag, {}, [](double lag) { return std::abs(lag - 1.0); });
  return static_cast<std::size_t>(nearest - autocorrelation.lag.begin());
}

const char* WhatIntervalsDoWithIt(Family family) {
  return family == Family::kAdaptive
             ? "The intervals of the adaptive law do not weigh that."
             : "The intervals weigh that as noise; where it is an effect that the model lacks, "
               "they are too short.";
}

const char* WhatSharesMean(const PowerShares& shares, double by_chance) {
  if (kMostByChance * by_chance >= 1.0) {
    return "The command excites nearly all frequencies, so that tells little.";
  }
  if (shares.within <= kMostByChance * by_chance) {
    return "That is no sign of a response that the model lacks.";
  }
  if (shares.within > std::max(shares.below, shares.above)) {
    return "Most of it is a response that the model lacks, or a disturbance as slow; "
           "fathom_diagnose looks for the former.";
  }
  return shares.below > shares.above
             ? "Most of it is slower than the command: an offset or a drift."
             : "Most of it is faster than the command: noise, a disturbance, or harmonics of a "
               "missing effect.";
}

CurvePanel AutocorrelationPanel(const Autocorrelation& autocorrelation) {
  CurvePanel panel;
  panel.x_name = "lag";
  panel.x_unit = "s";
  panel.y_name = "autocorrelation of the residual";
  panel.x = autocorrelation.lag;
  panel.y = autocorrelation.value;
  panel.high = autocorrelation.bound;
  for (const double bound : autocorrelation.bound) panel.low.push_back(-bound);
  panel.band_name = kWhiteNoise;
  return panel;
}

CurvePanel SpectrumPanel(const ResidualStructure& structure, std::string_view unit) {
  const Spectrum& spectrum = structure.spectrum;
  CurvePanel panel;
  panel.x_name = "frequency";
  panel.x_unit = "Hz";
  panel.y_name = "power of the residual";
  panel.y_unit = fmt::format("({})²/Hz", unit);
  panel.x = spectrum.frequency;
  panel.y = spectrum.density;
  panel.low.assign(panel.x.size(), spectrum.low);
  panel.high.assign(panel.x.size(), spectrum.high);
  panel.band_name = kWhiteNoise;
  panel.marked = structure.excited;
  panel.marked_name = "excited by the command";
  panel.is_log_x = panel.is_log_y = true;
  return panel;
}

}  // namespace

std::string AutocorrelationSentence(const ResidualStructure& structure, Family family) {
  const Autocorrelation& autocorrelation = structure.autocorrelation;
  if (autocorrelation.lag.empty()) return "";
  const double outside = ShareOutside(autocorrelation);
  const std::string share = fmt::format(
      "{:.0f} % of the lags are outside the bounds (white noise: 5 %)", 100.0 * outside);
  if (outside <= MostOutsideByChance(autocorrelation.lag.size())) {
    return fmt::format("Over time the residual looks like white noise: {}.", share);
  }
  const std::size_t second = LagOfASecond(autocorrelation);
  return fmt::format(
      "Samples of the residual {:.2g} s apart have a correlation of {:.2f}, and {}. {}",
      autocorrelation.lag[second],
      autocorrelation.value[second],
      share,
      WhatIntervalsDoWithIt(family));
}

std::string SpectrumSentence(const ResidualStructure& structure) {
  const Spectrum& spectrum = structure.spectrum;
  if (spectrum.frequency.empty() || !structure.excited) return "";
  const TimeInterval& band = *structure.excited;
  const PowerShares shares = SharesAbout(band, spectrum);
  const double by_chance = WhiteShareWithin(band, spectrum);
  return fmt::format(
      "From {:.2g} to {:.2g} Hz, where the command excites the vehicle, lies {:.0f} % of the "
      "residual's power (white noise: {:.0f} %); {:.0f} % lies below and {:.0f} % above. "
      "{}",
      band.from,
      band.to,
      100.0 * shares.within,
      100.0 * by_chance,
      100.0 * shares.below,
      100.0 * shares.above,
      WhatSharesMean(shares, by_chance));
}

PageFold RemainsFold(const Identification& taken, const Signals& scored) {
  PageFold fold;
  fold.summary = "What the model leaves";
  fold.text = {
      fmt::format("The residual of {}: measured less simulated from the command alone, "
                  "over training and held-out data.",
                  ModelName(taken))};
  const ResidualStructure structure = StructureOfResidual(taken.fitted.Extended(), scored);
  for (std::string sentence : {AutocorrelationSentence(structure, taken.family),
                               SpectrumSentence(structure),
                               CorrelationSentence(taken.fitted)}) {
    if (!sentence.empty()) fold.text.push_back(std::move(sentence));
  }
  if (!structure.autocorrelation.lag.empty()) {
    fold.curves.push_back(AutocorrelationPanel(structure.autocorrelation));
  }
  if (!structure.spectrum.frequency.empty()) {
    fold.curves.push_back(SpectrumPanel(structure, VelocityUnit(scored.dof)));
  }
  if (auto table = CorrelationTable(taken.fitted)) fold.tables.push_back(*std::move(table));
  return fold;
}

}  // namespace fathom
