// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen.h"

#include "fathom/base/random_stream.h"
#include "fathom/diagnosis/fit/force_response.h"
#include "fathom/simulate/partner_signals.h"
#include "fathom/vehicle/effect_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr double kProbe = 0.02;       // of the natural size, where an effect names no other
constexpr double kSpacing = 5.0;      // [s], of times of the run that are tried
constexpr double kFineSpacing = 0.2;  // [s], of times about one that looks good
constexpr double kFewestPeriods = 4.0;
constexpr double kFastest = 3.0;  // [rad/s], of frequencies that are tried

// The run's own scales.
struct NaturalSize {
  double force = 1.0;                        // RMS of the command [N] or [N m]
  double speed = 1.0;                        // RMS [m/s] or [rad/s]
  double first_time = 0.0, last_time = 1.0;  // since the first command sample [s]

  double Of(const Quantity& quantity) const {
    return std::pow(force, quantity.force) * std::pow(speed, quantity.speed);
  }
};

// Times of one log, or of all where it has no name.
void SetTimes(const TrainingData& data, const std::string& log, NaturalSize* size) {
  size->first_time = std::numeric_limits<double>::infinity();
  size->last_time = -std::numeric_limits<double>::infinity();
  for (const Record& record : data.records()) {
    if (!log.empty() && record.log != log) continue;
    const double start = record.stamps.start - record.inputs->command.time.front();
    size->first_time = std::min(size->first_time, start);
    size->last_time = std::max(size->last_time, start + record.duration());
  }
}

// Of all logs but for the times, which are of one where the suspect acts there alone.
NaturalSize SizeOf(const TrainingData& data,
                   const ForceResponse& response,
                   const Suspect& suspect) {
  NaturalSize size;
  double force = 0.0, speed = 0.0;
  for (const ForceResponse::Point& point : response.points()) {
    force += point.command * point.command;
    speed += point.velocity * point.velocity;
  }
  const auto n = static_cast<double>(response.points().size());
  size.force = std::max(1e-9, std::sqrt(force / n));
  size.speed = std::max(1e-9, std::sqrt(speed / n));
  SetTimes(data, suspect.setting.log, &size);
  return size;
}

double SpacingOfTimes(const NaturalSize& size) {
  const double span = size.last_time - size.first_time;
  return span / std::clamp(static_cast<int>(span / kSpacing), 10, 80);
}

std::vector<double> ValuesToTry(const EffectParameter& parameter, const NaturalSize& size) {
  const double natural = size.Of(parameter.quantity);
  std::vector<double> values;
  switch (parameter.search) {
    case Search::kAmount: {
      const double probe = natural * (parameter.trials.empty() ? kProbe : parameter.trials[0]);
      values.push_back(parameter.null + probe);
      break;
    }
    case Search::kSize:
    case Search::kShape:
      for (const double trial : parameter.trials) {
        const double value = trial * natural;
        if (value > parameter.lower && value < parameter.upper) values.push_back(value);
      }
      break;
    case Search::kTimeOfRun: {
      const double spacing = SpacingOfTimes(size);
      for (double t = size.first_time + spacing; t < size.last_time - 0.5 * spacing; t += spacing) {
        values.push_back(t);
      }
      break;
    }
    case Search::kFrequencyOfRun: {
      const double span = size.last_time - size.first_time;
      const double step = 1.3 * std::numbers::pi / span;
      // Of slower ones there are too few periods to tell them from a wandering force.
      const double slowest = kFewestPeriods * 2.0 * std::numbers::pi / span;
      for (double w = slowest; w < kFastest && values.size() < 250; w += step) {
        values.push_back(w);
      }
      break;
    }
  }
  return values;
}

bool IsShape(const EffectParameter& parameter) { return std::isnan(parameter.null); }

// The trials of one suspect: every combination of its parameters' values; a column per amount.
void AppendTrials(const TrainingData& data,
                  int suspect,
                  const EffectInfo& info,
                  const NaturalSize& size,
                  Trials* trials) {
  std::vector<int> amounts;
  for (size_t k = 0; k < info.parameters.size(); ++k) {
    if (!IsShape(info.parameters[k])) amounts.push_back(static_cast<int>(k));
  }
  std::vector<std::vector<double>> combinations = {{}};
  for (const EffectParameter& parameter : info.parameters) {
    std::vector<std::vector<double>> longer;
    for (const auto& begun : combinations) {
      for (const double value : ValuesToTry(parameter, size)) {
        longer.push_back(begun);
        longer.back().push_back(value);
      }
    }
    combinations = std::move(longer);
  }
  const EffectParameter& amount = info.parameters[amounts.front()];
  for (auto& values : combinations) {
    if (IsAtTheCommandsTone(data, info, values)) continue;
    Trial trial;
    trial.suspect = suspect;
    trial.values = std::move(values);
    trial.amounts = amounts;
    trial.any_sign = amount.search == Search::kAmount && amount.lower < amount.null &&
                     amount.upper > amount.null;
    trial.num_columns = static_cast<int>(amounts.size());
    trials->trials.push_back(std::move(trial));
  }
}

// The parameter values of a trial with only one of its amounts at its probe.
std::vector<double> WithOneAmount(const Trial& trial, const EffectInfo& info, int amount) {
  std::vector<double> values = trial.values;
  for (const int other : trial.amounts) {
    if (other != amount) values[other] = info.parameters[other].null;
  }
  return values;
}

bool IsForceInWater(const EffectLaw<double>& law) {
  return law.resistance && !law.memory_rate && !law.relative_speed;
}

// What an effect's resistance is along the run of the fitted model, as a force.
std::vector<double> ForceAlongRun(const TrainingData& data,
                                  const ForceResponse& response,
                                  const StructureFit& fit,
                                  const Suspect& suspect,
                                  const std::vector<double>& values) {
  std::vector<double> force;
  force.reserve(response.points().size());
  PartnerSignals partner;
  int record = -1;
  double time_zero = 0.0;
  bool acts = true;
  for (const ForceResponse::Point& point : response.points()) {
    if (point.record != record) {
      record = point.record;
      acts = suspect.setting.ActsIn(data.records()[record].log);
      const EffectInputs& inputs = *data.records()[record].inputs;
      if (suspect.effect->info().has_partner()) partner = PartnerSignals(inputs, suspect.setting);
      time_zero = inputs.command.time.front();
    }
    if (!acts) {
      force.push_back(0.0);
      continue;
    }
    Instant<double> now;
    now.time = point.time - time_zero;
    if (!partner.empty()) now.partner = partner.At(point.time, point.time, point.time);
    const WaterState<double> water = {point.velocity,
                                      point.velocity,
                                      point.position,
                                      point.velocity,
                                      fit.model.baseline.quadratic_damping,
                                      fit.model.baseline.linear_damping};
    force.push_back(-suspect.effect->law<double>().resistance(values.data(), water, now));
  }
  return force;
}

// Simulates every trial.
void AppendSignatures(const TrainingData& data,
                      const ForceResponse& response,
                      const StructureFit& fit,
                      const std::vector<Suspect>& suspects,
                      Trials* trials) {
  int num_columns = 0;
  for (Trial& trial : trials->trials) {
    trial.first_column = num_columns;
    num_columns += trial.num_columns;
  }
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(data.bins().size(), num_columns);
  const auto base = data.Simulate(fit.model, fit.initial);
  for (const Trial& trial : trials->trials) {
    const Suspect& suspect = suspects[trial.suspect];
    for (int k = 0; k < trial.num_columns; ++k) {
      const auto values = WithOneAmount(trial, suspect.effect->info(), trial.amounts[k]);
      auto column = columns.col(trial.first_column + k);
      if (IsForceInWater(suspect.effect->law<double>())) {
        column = response.Outputs(ForceAlongRun(data, response, fit, suspect, values));
        continue;
      }
      ExtendedModel model = WithEffect(fit.model, {suspect.effect, suspect.setting, values});
      if (!base) continue;
      if (const auto simulated = data.SimulateLog(suspect.setting.log, model, fit.initial, *base)) {
        column = *simulated - *base;
      }
    }
  }
  trials->signatures = columns;
}

}  // namespace

bool IsAtTheCommandsTone(const TrainingData& data,
                         const EffectInfo& info,
                         const std::vector<double>& values) {
  constexpr double kShareOfATone = 0.3;
  const Tone& tone = data.command_tone();
  if (!(tone.share > kShareOfATone)) return false;
  const double resolution = 2.0 * std::numbers::pi / data.longest_duration();
  for (size_t k = 0; k < info.parameters.size(); ++k) {
    if (info.parameters[k].search == Search::kFrequencyOfRun &&
        std::abs(values[k] - tone.frequency) < resolution) {
      return true;
    }
  }
  return false;
}

Trials TrialsAbout(const TrainingData& data,
                   const StructureFit& fit,
                   const std::vector<Suspect>& suspects) {
  Trials trials;
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return trials;
  for (size_t k = 0; k < suspects.size(); ++k) {
    const NaturalSize size = SizeOf(data, response, suspects[k]);
    AppendTrials(data, static_cast<int>(k), suspects[k].effect->info(), size, &trials);
  }
  AppendSignatures(data, response, fit, suspects, &trials);
  return trials;
}

Trials TrialsNear(const TrainingData& data,
                  const StructureFit& fit,
                  const std::vector<Suspect>& suspects,
                  const Trial& trial) {
  Trials trials;
  const auto& parameters = suspects[trial.suspect].effect->info().parameters;
  const auto time = std::find_if(parameters.begin(), parameters.end(), [](const auto& parameter) {
    return parameter.search == Search::kTimeOfRun;
  });
  if (time == parameters.end()) return trials;
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return trials;
  const NaturalSize size = SizeOf(data, response, suspects[trial.suspect]);
  const double middle = trial.values[time - parameters.begin()];
  const double reach = SpacingOfTimes(size);
  for (double t = std::max(size.first_time, middle - reach);
       t < std::min(size.last_time, middle + reach);
       t += kFineSpacing) {
    Trial near = trial;
    near.values[time - parameters.begin()] = t;
    trials.trials.push_back(std::move(near));
  }
  AppendSignatures(data, response, fit, suspects, &trials);
  return trials;
}

Screen::Screen(const StructureFit& fit, const Trials* trials, const Whitener& whitener)
    : trials_(trials) {
  const Eigen::Index n = fit.residual.size();
  const Eigen::Index num_fitted = fit.jacobian.cols();
  const Eigen::Index num_columns = trials->signatures.cols();
  RowMajorMatrix block(n, num_fitted + 1 + num_columns);
  block.leftCols(num_fitted) = fit.jacobian;
  block.col(num_fitted) = fit.residual;
  block.rightCols(num_columns) = trials->signatures;
  whitener.Apply(block, block);
  Eigen::MatrixXd fitted = block.leftCols(num_fitted);
  for (auto column : fitted.colwise()) column /= std::max(column.norm(), 1e-300);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(fitted);
  qr.setThreshold(1e-9);
  const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(n, qr.rank());
  Eigen::MatrixXd rest = block.rightCols(num_columns);
  Eigen::VectorXd residual = block.col(num_fitted);
  const Eigen::VectorXd norms = rest.colwise().norm();
  for (int repeat = 0; repeat < 2; ++repeat) {
    rest -= Q * (Q.transpose() * rest);
    residual -= Q * (Q.transpose() * residual);
  }
  unit_ = Eigen::MatrixXd::Zero(n, num_columns);
  const size_t num_trials = trials->trials.size();
  scores_.assign(num_trials, 0.0);
  surviving_shares_.assign(num_trials, 0.0);
  amounts_.resize(num_trials);
  for (size_t t = 0; t < num_trials; ++t) {
    const Trial& trial = trials->trials[t];
    const int first = trial.first_column, count = trial.num_columns;
    amounts_[t].assign(count, 0.0);
    const Eigen::MatrixXd own = rest.middleCols(first, count);
    double share = 0.0;
    for (int k = 0; k < count; ++k) {
      if (norms[first + k] > 0.0) share = std::max(share, own.col(k).norm() / norms[first + k]);
    }
    surviving_shares_[t] = share;
    if (!(share > 1e-5)) continue;  // rounding
    Eigen::MatrixXd basis = own;
    for (int k = 0; k < count; ++k) {
      for (int j = 0; j < k; ++j) basis.col(k) -= basis.col(j).dot(basis.col(k)) * basis.col(j);
      const double length = basis.col(k).norm();
      basis.col(k) *= length > 1e-9 * norms[first + k] ? 1.0 / length : 0.0;
    }
    const Eigen::VectorXd amounts = own.colPivHouseholderQr().solve(residual);
    if (!trial.any_sign && count == 1 && amounts[0] <= 0.0) {
      unit_.middleCols(first, count) = basis;
      continue;
    }
    unit_.middleCols(first, count) = basis;
    for (int k = 0; k < count; ++k) amounts_[t][k] = amounts[k];
    scores_[t] = (basis.transpose() * residual).squaredNorm();
  }
  projected_ = unit_.transpose() * residual;
}

double Screen::PairScore(int a, int b) const {
  const Trial& first = trials_->trials[a];
  const Trial& second = trials_->trials[b];
  Eigen::MatrixXd basis(unit_.rows(), first.num_columns + second.num_columns);
  basis << unit_.middleCols(first.first_column, first.num_columns),
      unit_.middleCols(second.first_column, second.num_columns);
  Eigen::VectorXd projected(basis.cols());
  projected << projected_.segment(first.first_column, first.num_columns),
      projected_.segment(second.first_column, second.num_columns);
  const Eigen::MatrixXd gram = basis.transpose() * basis;
  const Eigen::VectorXd solved = gram.ldlt().solve(projected);
  return solved.allFinite() ? projected.dot(solved) : 0.0;
}

Eigen::MatrixXd Screen::NullMaxima(int num_draws, int num_suspects, std::uint64_t seed) const {
  RandomStream random(seed, "diagnosis.null");
  const Eigen::Index n = unit_.rows();
  Eigen::MatrixXd maxima = Eigen::MatrixXd::Zero(num_draws, num_suspects);
  constexpr int kBlock = 64;
  for (int done = 0; done < num_draws; done += kBlock) {
    const int count = std::min(kBlock, num_draws - done);
    Eigen::MatrixXd noise(n, count);
    for (double& number : noise.reshaped()) number = random.Normal();
    const Eigen::MatrixXd z = unit_.transpose() * noise;
    for (int draw = 0; draw < count; ++draw) {
      for (const Trial& trial : trials_->trials) {
        const auto own = z.col(draw).segment(trial.first_column, trial.num_columns);
        // Half of the one-sided trials would have the wrong sign.
        if (!trial.any_sign && trial.num_columns == 1 && own[0] <= 0.0) continue;
        double& most = maxima(done + draw, trial.suspect);
        most = std::max(most, own.squaredNorm());
      }
    }
  }
  return maxima;
}

}  // namespace fathom
