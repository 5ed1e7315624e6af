// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Seeded runs of every DOF, input and number of markers: what each family makes of the same
// corners. The tables of docs/joint_refinement.md on stdout, one line per run on stderr.
//
//   joint_table --jobs=2
//   joint_table --only=heave,one --wander_angle=0.001

#include "fathom/base/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

#include "camera_experiment.h"
#include "joint_trial.h"
#include "side_by_side.h"
#include <fmt/format.h>
#include <gflags/gflags.h>
#include <glog/logging.h>

DEFINE_int32(seeds, 20, "runs of each row");
DEFINE_uint32(first_seed, 1, "the seed of a row's first run; the others follow it");
DEFINE_int32(jobs, 2, "runs at a time");
DEFINE_string(only, "", "comma between: words that a row's name must have, as in 'heave,sine,one'");
DEFINE_string(wander, "filtered", "of the other coordinates: filtered, sinusoids, rough or none");
DEFINE_double(wander_angle, 0.002, "its standard deviation [rad]");
DEFINE_double(outliers, 0.0, "share of detections whose corners are somewhere else");
DEFINE_double(flips, 0.0, "share of frames whose first pose is the square's other solution");
DEFINE_double(pitch_per_acceleration,
              0.0,
              "pitch follows the excited DOF's acceleration [rad s^2/m]");
DEFINE_double(duration, 300.0, "of a run [s]");

namespace fathom {
namespace {

struct Row {
  Dof dof;
  int num_markers;
  std::string name;
  std::vector<CameraExperiment> experiments;
  std::vector<JointTrial> trials;  // usable ones; each as its experiment
  int num_unusable = 0;
};

WanderKind WanderOf(const std::string& name) {
  const std::map<std::string, WanderKind> kinds = {{"filtered", WanderKind::kFiltered},
                                                   {"sinusoids", WanderKind::kSinusoids},
                                                   {"rough", WanderKind::kRough},
                                                   {"none", WanderKind::kNone}};
  const auto found = kinds.find(name);
  CHECK(found != kinds.end()) << "--wander is '" << name
                              << "', expected filtered, sinusoids, rough or none";
  return found->second;
}

bool HasAllWords(const std::string& name, const std::string& only) {
  std::istringstream words(only);
  for (std::string word; std::getline(words, word, ',');) {
    if ((", " + name + ",").find(" " + word + ",") == std::string::npos) return false;
  }
  return true;
}

std::vector<Row> RowsByFlags() {
  CameraExperiment base;
  base.wander = WanderOf(FLAGS_wander);
  base.wander_angle = FLAGS_wander_angle;
  base.outliers = FLAGS_outliers;
  base.flips = FLAGS_flips;
  base.pitch_per_acceleration = FLAGS_pitch_per_acceleration;
  base.duration = FLAGS_duration;
  std::vector<Row> rows;
  for (const int num_markers : {1, 4}) {
    for (const Dof dof : {Dof::kSurge, Dof::kHeave, Dof::kYaw}) {
      for (const auto& [input, input_name] : {std::pair{InputKind::kSine, "sine"},
                                              std::pair{InputKind::kMultisine, "multisine"},
                                              std::pair{InputKind::kSteps, "steps"}}) {
        Row row = {
            dof,
            num_markers,
            fmt::format("{}, {}, {}", Name(dof), input_name, num_markers == 1 ? "one" : "four"),
            {},
            {}};
        if (!HasAllWords(row.name, FLAGS_only)) continue;
        for (int k = 0; k < FLAGS_seeds; ++k) {
          CameraExperiment experiment = base;
          experiment.dof = dof;
          experiment.input = input;
          experiment.num_markers = num_markers;
          experiment.seed = FLAGS_first_seed + static_cast<unsigned>(k);
          row.experiments.push_back(experiment);
        }
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

void Report(const Row& row, const CameraExperiment& experiment, const JointTrial& trial) {
  fmt::print(stderr,
             "{} {}: published LS {:.6f} LS {:.6f} OE {:.6f} joint {:.6f} over std {:.2f} over "
             "bound {:.2f} NMAE "
             "{:.5f} of {:.5f} position {:.3f} attitude {:.3f} {:.1f} s{}\n",
             row.name,
             experiment.seed,
             trial.published_least_squares,
             trial.least_squares,
             trial.output_error,
             trial.joint,
             fmt::join(trial.over_std, " "),
             fmt::join(trial.over_bound, " "),
             trial.nmae,
             trial.sensor_nmae,
             trial.position,
             trial.attitude,
             trial.seconds,
             trial.is_usable ? "" : ": not usable");
}

void RunAll(std::vector<Row>* rows) {
  struct Job {
    Row* row;
    std::size_t place;
  };
  std::vector<Job> jobs;
  for (Row& row : *rows) {
    row.trials.resize(row.experiments.size());
    for (std::size_t k = 0; k < row.trials.size(); ++k) jobs.push_back({&row, k});
  }
  std::mutex mutex;
  SideBySide(jobs.size(), FLAGS_jobs, [&](std::size_t i) {
    const auto& [row, place] = jobs[i];
    row->trials[place] = RunJointTrial(row->experiments[place]);
    const std::lock_guard<std::mutex> lock(mutex);
    Report(*row, row->experiments[place], row->trials[place]);
  });
  for (Row& row : *rows) {
    row.num_unusable = static_cast<int>(
        std::erase_if(row.trials, [](const JointTrial& trial) { return !trial.is_usable; }));
  }
}

// One figure of each trial.
using Figure = std::function<double(const JointTrial&)>;
using Trials = std::vector<JointTrial>;

std::vector<double> Collect(const Trials& trials, const Figure& figure) {
  std::vector<double> values;
  for (const JointTrial& trial : trials) values.push_back(figure(trial));
  return values;
}

double MedianOf(const Trials& trials, const Figure& figure) {
  return Median(Collect(trials, figure));
}

double WorstOf(const Trials& trials, const Figure& figure) {
  const std::vector<double> values = Collect(trials, figure);
  return *std::max_element(values.begin(), values.end());
}

int CountBetterThanSensor(const Trials& trials) {
  return static_cast<int>(std::count_if(trials.begin(), trials.end(), [](const JointTrial& trial) {
    return trial.nmae < trial.sensor_nmae;
  }));
}

// RMS error over the Cramer-Rao bound, of the first `num` parameters.
double OverBound(const Trials& trials, int num) {
  double sum = 0.0;
  for (const JointTrial& trial : trials) {
    for (int i = 0; i < num; ++i) sum += trial.over_bound[i] * trial.over_bound[i];
  }
  return std::sqrt(sum / static_cast<double>(num * static_cast<int>(trials.size())));
}

double PercentCovered(const Trials& trials) {
  int num_covered = 0;
  for (const JointTrial& trial : trials) {
    for (const double z : trial.over_std) num_covered += std::abs(z) < 1.96;
  }
  return 100.0 * num_covered / (4.0 * static_cast<double>(trials.size()));
}

double Published(const JointTrial& trial) { return std::abs(trial.published_least_squares); }
double LeastSquares(const JointTrial& trial) { return std::abs(trial.least_squares); }
double OutputError(const JointTrial& trial) { return std::abs(trial.output_error); }
double Joint(const JointTrial& trial) { return std::abs(trial.joint); }

void PrintRows(const std::vector<Row>& rows) {
  fmt::print(
      "| run | published | least squares | output error | joint | bound | all four | 95 % | NMAE "
      "| NMAE, sensor | better than the sensor | path "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows) {
    const Trials& trials = row.trials;
    if (trials.empty()) continue;
    fmt::print(
        "| {} | {:.2g} | {:.2g} | {:.2g} | {:.2g} | {:.2f} | {:.2f} | {:.0f} | {:.5f} | {:.4f} "
        "| {} of {} | {:.3f} |\n",
        row.name,
        100.0 * MedianOf(trials, Published),
        100.0 * MedianOf(trials, LeastSquares),
        100.0 * MedianOf(trials, OutputError),
        100.0 * MedianOf(trials, Joint),
        OverBound(trials, 1),
        OverBound(trials, 4),
        PercentCovered(trials),
        MedianOf(trials, &JointTrial::nmae),
        MedianOf(trials, &JointTrial::sensor_nmae),
        CountBetterThanSensor(trials),
        trials.size(),
        MedianOf(trials, &JointTrial::position));
  }
}

// The trials of some DOFs with one marker, with four, and with either.
using ByMarkers = std::array<Trials, 3>;

ByMarkers TrialsOf(const std::vector<Row>& rows, const std::vector<Dof>& dofs) {
  ByMarkers trials;
  for (const Row& row : rows) {
    if (std::find(dofs.begin(), dofs.end(), row.dof) == dofs.end()) continue;
    for (Trials* some : {&trials[row.num_markers == 1 ? 0 : 1], &trials[2]}) {
      some->insert(some->end(), row.trials.begin(), row.trials.end());
    }
  }
  return trials;
}

void PrintLine(const std::string& name,
               const ByMarkers& by_markers,
               const std::function<std::string(const Trials&)>& text) {
  fmt::print("| {} |", name);
  for (const Trials& trials : by_markers) fmt::print(" {} |", trials.empty() ? "" : text(trials));
  fmt::print("\n");
}

// Of two figures of each run: the median of the ratios, and the ratio of the medians.
std::string RatioText(const Trials& trials, const Figure& above, const Figure& below) {
  return fmt::format(
      "{:.2g}, {:.2g}",
      MedianOf(trials, [&](const JointTrial& trial) { return above(trial) / below(trial); }),
      MedianOf(trials, above) / MedianOf(trials, below));
}

void PrintSummary(const std::vector<Row>& rows) {
  const std::vector<std::pair<std::string, std::vector<Dof>>> groups = {
      {"surge", {Dof::kSurge}},
      {"heave", {Dof::kHeave}},
      {"yaw", {Dof::kYaw}},
      {"all three", {Dof::kSurge, Dof::kHeave, Dof::kYaw}}};
  fmt::print("\n| runs | one marker | four markers | either |\n|---|---|---|---|\n");
  for (const auto& [name, dofs] : groups) {
    const ByMarkers trials = TrialsOf(rows, dofs);
    if (trials[2].empty()) continue;
    PrintLine(name + ": joint over published least squares", trials, [](const Trials& all) {
      return RatioText(all, Joint, Published);
    });
    PrintLine(name + ": joint over least squares", trials, [](const Trials& all) {
      return RatioText(all, Joint, LeastSquares);
    });
    PrintLine(name + ": output error over joint", trials, [](const Trials& all) {
      return RatioText(all, OutputError, Joint);
    });
    PrintLine(name + ": better than the sensor", trials, [](const Trials& all) {
      return fmt::format("{} of {}", CountBetterThanSensor(all), all.size());
    });
    PrintLine(name + ": over the bound, inertia and all four", trials, [](const Trials& all) {
      return fmt::format("{:.2f}, {:.2f}", OverBound(all, 1), OverBound(all, 4));
    });
    PrintLine(name + ": in the 95 % intervals", trials, [](const Trials& all) {
      return fmt::format("{:.1f} % of {}", PercentCovered(all), 4 * all.size());
    });
    PrintLine(name + ": path, median and worst", trials, [](const Trials& all) {
      return fmt::format("{:.3f}, {:.3f}",
                         MedianOf(all, &JointTrial::position),
                         WorstOf(all, &JointTrial::position));
    });
  }
  int num_unusable = 0;
  for (const Row& row : rows) num_unusable += row.num_unusable;
  fmt::print("\nRuns left out because a family had no usable fit: {}.\n", num_unusable);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  gflags::SetUsageMessage("compares the families on the corners of simulated runs");
  gflags::ParseCommandLineFlags(&argc, &argv, true);
  FLAGS_logtostderr = true;
  google::InitGoogleLogging(argv[0]);
  std::vector<fathom::Row> rows = fathom::RowsByFlags();
  CHECK(!rows.empty()) << "--only is '" << FLAGS_only
                       << "', expected words of a row's name as in 'heave,sine,one'";
  fathom::RunAll(&rows);
  fathom::PrintRows(rows);
  fathom::PrintSummary(rows);
  return 0;
}
