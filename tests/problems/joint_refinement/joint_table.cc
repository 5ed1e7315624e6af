// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Seeded runs of every DOF, input and number of markers: what each family makes of the same
// corners. The figures of docs/joint_refinement.md. One line per run on stderr, the table on
// stdout.
//
//   joint_table [first_seed=1] [num_seeds=20] [wander=0] [cells=all, or dof.input.markers]
//               [outliers=0] [flips=0] [pitch_per_acceleration=0] [duration=300]
//               [wander_angle=0.002]

#include "fathom/least_squares/least_squares.h"
#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/prediction.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "camera_experiment.h"
#include "cramer_rao.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Row {
  double least_squares = kNaN, output_error = kNaN, joint = kNaN;  // relative error of the inertia
  std::array<double, 4> z = {kNaN, kNaN, kNaN, kNaN};              // error over reported std
  std::array<double, 4> over_bound = {kNaN, kNaN, kNaN, kNaN};     // error over Cramer-Rao bound
  double nmae = kNaN, sensor_nmae = kNaN;  // against the true velocity: joint, output error on DVL
  double trajectory = kNaN;                // RMS position error, refined over PnP
  double angle = kNaN;                     // the same of the attitude
  double seconds = kNaN;
};

// NMAE of the free run from the true first velocity against the true velocity.
double TrueNmae(const UncoupledModel<double>& model, const SyntheticCameraRun& run, double v0) {
  Segment segment;
  segment.time = run.input.runs[0].time;
  segment.velocity = run.true_velocity;
  segment.command = run.input.runs[0].command;
  const auto v = PredictVelocity(model, segment, v0);
  if (!v) return kNaN;
  double miss = 0.0, size = 0.0;
  for (size_t k = 0; k < v->size(); ++k) {
    miss += std::abs((*v)[k] - segment.velocity[k]);
    size += std::abs(segment.velocity[k]);
  }
  return miss / size;
}

Row Measure(const CameraExperiment& experiment) {
  Row row;
  const SyntheticCameraRun run = Synthesize(experiment);
  const double truth = run.truth.inertia;
  const Signals signals = SignalsOf(PoseLog(run), experiment.dof, {.source = Source::kCamera});
  const auto least_squares = FitLeastSquares(signals.train);
  if (least_squares.IsUsable()) row.least_squares = least_squares.model.inertia / truth - 1.0;
  const auto output_error =
      FitOutputError(signals.train, {.initial_guess = {}, .output = FittedOutput::kPosition});
  if (output_error.IsUsable()) row.output_error = output_error.model.inertia / truth - 1.0;

  Segment sensor;
  sensor.time = run.input.runs[0].time;
  sensor.command = run.input.runs[0].command;
  std::mt19937 generator(experiment.seed);
  std::normal_distribution<double> normal;
  for (const double v : run.true_velocity) sensor.velocity.push_back(v + 0.01 * normal(generator));
  OutputErrorOptions from_truth;
  from_truth.initial_guess = run.truth;
  const std::vector<Segment> sensors = {sensor};
  const auto by_sensor = FitOutputError(sensors, from_truth);
  if (by_sensor.IsUsable()) {
    row.sensor_nmae = TrueNmae(by_sensor.model, run, by_sensor.initial_states[0].velocity);
  }

  const auto begin = std::chrono::steady_clock::now();
  const JointSummary joint = FitJoint(run.input);
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!joint.IsUsable()) {
    fmt::print(stderr, "joint: {}\n", joint.message);
    return row;
  }
  row.joint = joint.model.inertia / truth - 1.0;
  row.z = {
      (joint.model.inertia - truth) / std::sqrt(joint.covariance(0, 0)),
      (joint.model.quadratic_damping - run.truth.quadratic_damping) /
          std::sqrt(joint.covariance(1, 1)),
      (joint.model.linear_damping - run.truth.linear_damping) / std::sqrt(joint.covariance(2, 2)),
      (joint.model.buoyancy - run.truth.buoyancy) / std::sqrt(joint.covariance(3, 3))};
  const bool has_bound =
      experiment.wander == WanderKind::kFiltered && experiment.pitch_per_acceleration == 0.0;
  if (has_bound) {
    const ParameterVector bound = CramerRaoStd(experiment, run);
    const ParameterVector error = ToVector(joint.model) - ToVector(run.truth);
    for (int i = 0; i < kNumParameters; ++i) row.over_bound[i] = error[i] / bound[i];
  }
  row.nmae = TrueNmae(joint.model, run, joint.runs[0].start.velocity);
  double refined = 0.0, pnp = 0.0, refined_angle = 0.0, pnp_angle = 0.0;
  const auto square = [](double x) { return x * x; };
  for (size_t k = 0; k < run.true_velocity.size(); ++k) {
    const Pose& true_pose = run.true_world_from_body[k];
    const Pose& first = run.input.runs[0].world_from_body[k];
    const Pose& last = joint.runs[0].world_from_body[k];
    refined += (last.translation - true_pose.translation).squaredNorm();
    pnp += (first.translation - true_pose.translation).squaredNorm();
    refined_angle += square(last.rotation.angularDistance(true_pose.rotation));
    pnp_angle += square(first.rotation.angularDistance(true_pose.rotation));
  }
  row.trajectory = std::sqrt(refined / pnp);
  row.angle = std::sqrt(refined_angle / pnp_angle);
  return row;
}

double Median(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return kNaN;
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

template <typename Get>
std::vector<double> Collect(const std::vector<Row>& rows, Get get) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(get(row));
  return values;
}

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0, count = 0.0;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    sum += v * v;
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

// Of the four parameters of each row.
template <typename Member>
std::vector<double> CollectAll(const std::vector<Row>& rows, Member member) {
  std::vector<double> values;
  for (const Row& row : rows)
    values.insert(values.end(), (row.*member).begin(), (row.*member).end());
  return values;
}

template <typename Holds>
double PercentOf(const std::vector<double>& values, Holds holds) {
  return 100.0 * static_cast<double>(std::count_if(values.begin(), values.end(), holds)) /
         static_cast<double>(values.size());
}

void PrintLine(const std::string& name, const std::vector<Row>& rows) {
  const auto median = [&](auto get) { return Median(Collect(rows, get)); };
  const auto ratio = [](double a, double b) { return std::abs(a) / std::abs(b); };
  fmt::print(
      "| {} | {:.3f} | {:.3f} | {:.4f} | {:.3f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {:.5f} | "
      "{:.5f} | {:.0f} | {:.2f} | {:.2f} | {:.1f} |\n",
      name,
      100.0 * median([](const Row& r) { return std::abs(r.least_squares); }),
      100.0 * median([](const Row& r) { return std::abs(r.output_error); }),
      100.0 * median([](const Row& r) { return std::abs(r.joint); }),
      median([&](const Row& r) { return ratio(r.joint, r.least_squares); }),
      median([&](const Row& r) { return ratio(r.output_error, r.joint); }),
      RootMeanSquare(Collect(rows, [](const Row& r) { return r.over_bound[0]; })),
      RootMeanSquare(CollectAll(rows, &Row::over_bound)),
      PercentOf(CollectAll(rows, &Row::z), [](double z) { return std::abs(z) < 1.96; }),
      median([](const Row& r) { return r.nmae; }),
      median([](const Row& r) { return r.sensor_nmae; }),
      PercentOf(Collect(rows, [](const Row& r) { return r.nmae / r.sensor_nmae; }),
                [](double q) { return q < 1.0; }),
      median([](const Row& r) { return r.trajectory; }),
      std::max_element(rows.begin(),
                       rows.end(),
                       [](const Row& a, const Row& b) { return a.trajectory < b.trajectory; })
          ->trajectory,
      median([](const Row& r) { return r.seconds; }));
  std::fflush(stdout);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  using namespace fathom;
  const auto number = [&](int i, int otherwise) {
    return argc > i ? std::atoi(argv[i]) : otherwise;
  };
  const int first_seed = number(1, 1), num_seeds = number(2, 20);
  const std::string only = argc > 4 ? argv[4] : "";
  CameraExperiment base;
  base.wander = static_cast<WanderKind>(number(3, 0));
  if (argc > 5) base.outliers = std::atof(argv[5]);
  if (argc > 6) base.flips = std::atof(argv[6]);
  if (argc > 7) base.pitch_per_acceleration = std::atof(argv[7]);
  if (argc > 8) base.duration = std::atof(argv[8]);
  if (argc > 9) base.wander_angle = std::atof(argv[9]);
  fmt::print(
      "| run | LS % | OE % | joint % | joint/LS | OE/joint | error/bound | all parameters | 95 % | "
      "NMAE | NMAE of sensor | better % | path | worst | s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const std::array<const char*, 3> inputs = {"sine", "multisine", "steps"};
  std::vector<Row> all, single;
  std::map<std::string, std::vector<Row>> by_dof;
  for (const int markers : {1, 4}) {
    for (const Dof dof : {Dof::kSurge, Dof::kHeave, Dof::kYaw}) {
      for (int input = 0; input < 3; ++input) {
        const std::string name = fmt::format("{}.{}.{}", Name(dof), inputs[input], markers);
        if (!only.empty() && name.find(only) == std::string::npos) continue;
        std::vector<Row> rows;
        for (int seed = first_seed; seed < first_seed + num_seeds; ++seed) {
          CameraExperiment experiment = base;
          experiment.dof = dof;
          experiment.input = static_cast<InputKind>(input);
          experiment.num_markers = markers;
          experiment.seed = static_cast<unsigned>(seed);
          const Row row = Measure(experiment);
          fmt::print(stderr,
                     "{} {}: LS {:.6f} OE {:.6f} joint {:.6f} z {:.2f} {:.2f} {:.2f} {:.2f} NMAE "
                     "{:.5f} of {:.5f} path {:.3f} angle {:.3f} bound {:.2f} {:.2f} {:.2f} {:.2f} "
                     "{:.1f} s\n",
                     name,
                     seed,
                     row.least_squares,
                     row.output_error,
                     row.joint,
                     row.z[0],
                     row.z[1],
                     row.z[2],
                     row.z[3],
                     row.nmae,
                     row.sensor_nmae,
                     row.trajectory,
                     row.angle,
                     row.over_bound[0],
                     row.over_bound[1],
                     row.over_bound[2],
                     row.over_bound[3],
                     row.seconds);
          rows.push_back(row);
        }
        PrintLine(name, rows);
        all.insert(all.end(), rows.begin(), rows.end());
        auto& of_dof =
            by_dof[fmt::format("{}, {} marker{}", Name(dof), markers, markers > 1 ? "s" : "")];
        of_dof.insert(of_dof.end(), rows.begin(), rows.end());
        if (markers == 1) single.insert(single.end(), rows.begin(), rows.end());
      }
    }
  }
  for (const auto& [name, rows] : by_dof) PrintLine(name, rows);
  if (!single.empty()) PrintLine("one marker", single);
  PrintLine("all", all);
  return 0;
}
