// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "example_page.h"

#include "fathom/report/format_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr int kNumStamps = 3000;
constexpr double kStep = 0.1;  // [s]
constexpr std::array<const char*, 4> kFamilies = {
    "least_squares", "adaptive", "output_error", "joint"};
constexpr std::array<const char*, 4> kNames = {
    "inertia", "quadratic_damping", "linear_damping", "buoyancy"};

// m v' + d_Q v|v| + d_L v + b = tau with the family's error in the parameters.
std::vector<double> Simulate(const std::array<double, 4>& p, const std::vector<double>& force) {
  std::vector<double> velocity = {0.0};
  for (int i = 1; i < kNumStamps; ++i) {
    const double v = velocity.back();
    velocity.push_back(v + kStep * (force[i - 1] - (p[1] * std::abs(v) + p[2]) * v - p[3]) / p[0]);
  }
  return velocity;
}

TimePanel CommandPanel(const std::string& dof, double force_size, unsigned seed) {
  TimePanel command;
  command.quantity = dof == "yaw" ? "torque" : "force";
  command.unit = dof == "yaw" ? "N m" : "N";
  command.is_stepped = true;
  std::vector<double> force;
  for (int i = 0; i < kNumStamps; ++i) {
    const double t = kStep * i;
    const double level = std::sin(0.05 * t + seed) + 0.6 * std::sin(0.21 * t) > 0.0 ? 1.0 : -0.7;
    force.push_back(force_size * std::round(4.0 * level * (0.6 + 0.4 * std::sin(0.013 * t))) / 4.0);
    command.time.push_back(t);
  }
  command.responses = {{"commanded", force, ""}};
  return command;
}

double LargestOf(const std::vector<double>& velocity) {
  double top = 0.0;
  for (const double v : velocity) top = std::max(top, std::abs(v));
  return top;
}

// With drift and noise of `top`, and without a stretch where the camera lost the markers.
std::vector<double> Measured(std::vector<double> velocity, double top, std::mt19937* generator) {
  std::normal_distribution<double> normal;
  double drift = 0.0;
  for (int i = 0; i < kNumStamps; ++i) {
    drift += 0.02 * top * kStep * normal(*generator) - 0.05 * kStep * drift;
    velocity[i] += drift + 0.02 * top * normal(*generator);
    if (i > 1310 && i < 1370) velocity[i] = std::nan("");
  }
  return velocity;
}

double MeanError(const std::vector<double>& measured, const std::vector<double>& response) {
  double mae = 0.0;
  int n = 0;
  for (int i = 0; i < kNumStamps; ++i) {
    const double error = measured[i] - response[i];
    if (std::isnan(error)) continue;
    mae += std::abs(error);
    ++n;
  }
  return mae / n;
}

// What one family found: in the table, the parameter panels and the plot of the motion.
void AddFamily(std::size_t family,
               bool is_unusable,
               const std::array<double, 4>& truth,
               const std::vector<double>& force,
               double top,
               std::mt19937* generator,
               PageSection* section,
               TimePanel* motion) {
  const std::array<double, 4> spread = {0.06, 0.15, 0.02, 0.012};
  std::normal_distribution<double> normal;
  std::array<double, 4> p = truth;
  for (int k = 0; k < 4; ++k) {
    const double std = spread[family] * std::abs(truth[k]);
    p[k] += std * normal(*generator);
    const bool has_interval = family != 1;
    section->parameter_panels[k].estimates.push_back(
        {kFamilies[family],
         is_unusable ? std::nan("") : (family == 0 && k == 2 ? 40.0 * p[k] : p[k]),
         has_interval ? std : std::nan("")});
  }
  Series response{kFamilies[family], Simulate(p, force), ""};
  const double mae = MeanError(motion->measured->values, response.values);
  const std::string percent = FormatValue(100.0 * mae / top).substr(0, 4);
  response.note = percent + " %";
  const double inertia_std = family == 1 ? std::nan("") : spread[family] * truth[0];
  section->tables.front().rows.push_back(
      {{kFamilies[family],
        is_unusable ? "-" : FormatValue(mae),
        is_unusable ? "-" : percent,
        is_unusable ? "-" : FormatValue(130.0 * mae / top).substr(0, 4),
        is_unusable ? "-" : FormatValue(p[0], inertia_std),
        family == 3 ? "camera" : "pose_estimator"},
       is_unusable   ? RowFlag::kUnusable
       : family == 2 ? RowFlag::kBest
                     : RowFlag::kNone});
  if (!is_unusable) motion->responses.push_back(std::move(response));
}

PageSection ExampleSection(const std::string& dof,
                           const std::string& unit,
                           const std::array<double, 4>& truth,
                           const std::array<std::string, 4>& units,
                           double force_size,
                           unsigned seed) {
  std::mt19937 generator(seed);
  const TimePanel command = CommandPanel(dof, force_size, seed);
  const std::vector<double>& force = command.responses.front().values;
  const std::vector<double> true_velocity = Simulate(truth, force);
  const double top = LargestOf(true_velocity);
  TimePanel motion;
  motion.quantity = dof + " velocity";
  motion.unit = unit;
  motion.time = command.time;
  motion.held_out = {{200.0, 245.0}};
  motion.measured = Series{"measured", Measured(true_velocity, top, &generator), ""};

  PageSection section;
  section.heading = dof == "yaw" ? "Yaw" : dof == "heave" ? "Heave" : "Surge";
  section.text = {
      "The free run of output_error stays within 5 % of the measured range; the adaptive "
      "law has not settled by the end of the log."};
  Table& table = section.tables.emplace_back();
  table.columns = {{"family"},
                   {"MAE [" + unit + "]", true},
                   {"nMAE [%]", true},
                   {"held out [%]", true},
                   {"inertia [" + units[0] + "]", true},
                   {"source"}};
  section.parameter_panels.resize(4);
  for (int k = 0; k < 4; ++k) {
    section.parameter_panels[k].name = kNames[k];
    section.parameter_panels[k].unit = units[k];
    section.parameter_panels[k].reference = truth[k];
  }
  for (std::size_t family = 0; family < kFamilies.size(); ++family) {
    const bool is_unusable = dof == "yaw" && family == 1;
    AddFamily(family, is_unusable, truth, force, top, &generator, &section, &motion);
  }
  section.time_panels = {motion, command};
  return section;
}

}  // namespace

Page ExamplePage() {
  Page page;
  page.title = "Four families on pool_run_3";
  page.subtitle = "3 degrees of freedom, 300 s, 10 Hz; made-up data";
  page.lead = {
      "output_error predicts all three degrees of freedom best, within 5 % of the measured "
      "range on data that no fit has seen.",
      "least_squares agrees with it on the inertia but not on the damping, which the camera's "
      "noise biases."};
  page.facts = {{"log", "data/pool_run_3"},
                {"duration", "300 s"},
                {"held out", "200 s to 245 s"},
                {"sources", "pose_estimator, camera"},
                {"best family", "output_error"}};
  page.warnings = {"Yaw: the adaptive law diverged; its gains are too high for this log."};
  page.sections = {
      ExampleSection(
          "surge", "m/s", {890.3, 410.0, 95.0, 4.2}, {"kg", "kg/m", "kg/s", "N"}, 220.0, 1),
      ExampleSection(
          "heave", "m/s", {1210.0, 905.0, 140.0, -12.5}, {"kg", "kg/m", "kg/s", "N"}, 180.0, 2),
      ExampleSection("yaw",
                     "rad/s",
                     {212.0, 150.0, 60.0, 0.8},
                     {"kg m^2", "kg m^2", "kg m^2/s", "N m"},
                     45.0,
                     3)};
  page.footer = "Fathom 0.1.0, fathom_compare --log=data/pool_run_3 --report=compare.html";
  return page;
}

}  // namespace fathom
