// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Round trip by MATLAB and Octave: a log is made from a vehicle, a model identified from it and
// exported with --format=mss, and the held-out command of the log run in Octave. Its NMAE,
// docs/models.md (8), is fathom_simulate's.

#include "fathom/log/read_log.h"
#include "fathom/simulate/coupled/coupled_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "octave.h"
#include "run_tool.h"
#include "saved_files.h"
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using Path = std::filesystem::path;

const std::map<std::string, int> kRowOf = {
    {"surge", 1}, {"sway", 2}, {"heave", 3}, {"roll", 4}, {"pitch", 5}, {"yaw", 6}};

// What a round trip begins with, and the files that it leaves in `folder`.
struct RoundTrip {
  Path folder = EmptyTestFolder();
  std::vector<std::string> dofs;  // in the order of the columns of the log
  Path log = folder / "log", model = folder / "model.json", prediction = folder / "prediction.csv";
  Path score = folder / "score.json", function = folder / "vehicle.m";

  void Make(const std::string& vehicle, const Path& experiment) const {
    RunsWell("fathom_synthesize",
             {Flag("vehicle", Path(kData) / "vehicles" / vehicle),
              Flag("experiment", experiment),
              "--seed=3",
              Flag("out", log)});
    std::vector<std::string> flags = {Flag("log", log), Flag("model", model)};
    if (dofs.size() == 1) {
      flags.push_back("--dof=" + dofs.front());
    } else {
      flags.push_back(fmt::format("--dofs={}", fmt::join(dofs, ",")));
      flags.emplace_back("--structure=symmetric");
    }
    RunsWell("fathom_identify", flags);
    RunsWell(
        "fathom_simulate",
        {Flag("model", model), Flag("log", log), Flag("out", prediction), Flag("json", score)});
    RunsWell("fathom_export", {Flag("model", model), "--format=mss", Flag("out", function)});
  }
};

// The held-out NMAE of each DOF as Octave gives it: classical Runge-Kutta steps of vehicle.m of at
// most 0.02 s, none across a stamp of the commands, which hold until the next, nor of the
// velocities. It begins at the first held-out stamp as fathom_simulate does, at `angles` [rad].
std::vector<double> NmaeInOctave(const RoundTrip& trip,
                                 double held_out_from,
                                 const Eigen::Vector3d& angles = Eigen::Vector3d::Zero()) {
  std::vector<int> rows;
  for (const std::string& dof : trip.dofs) rows.push_back(kRowOf.at(dof));
  std::string script = fmt::format(
      "addpath('{}');\n"
      "command = dlmread('{}', ',', 1, 0);\n"
      "measured = dlmread('{}', ',', 1, 0);\n"
      "predicted = dlmread('{}', ',', 1, 0);\n"
      "rows = [{}];\n"
      "from = {};\n"
      "angles = [{:.17g}; {:.17g}; {:.17g}];\n",
      trip.folder.string(),
      (trip.log / "command.csv").string(),
      (trip.log / "velocity.csv").string(),
      trip.prediction.string(),
      fmt::join(rows, " "),
      held_out_from,
      angles[0],
      angles[1],
      angles[2]);
  script += R"(
held_out = find(measured(:,1) >= from)';
x = zeros(12,1); ui = zeros(6,1);
x(rows) = predicted(held_out(1), 2:numel(rows)+1);
x(10:12) = angles;
t = measured(held_out(1), 1);
missed = 0;
for k = held_out
  while t < measured(k,1)
    i = find(command(:,1) <= t, 1, 'last');
    ui(rows) = command(i, 2:end);
    next = min([measured(k,1); command(i+1:end,1); t + 0.02]);
    h = next - t;
    k1 = vehicle(x, ui);
    k2 = vehicle(x + h/2*k1, ui);
    k3 = vehicle(x + h/2*k2, ui);
    k4 = vehicle(x + h*k3, ui);
    x = x + h/6*(k1 + 2*k2 + 2*k3 + k4);
    t = next;
  end
  missed = missed + abs(x(rows)' - measured(k,2:end));
end
printf('%.17g\n', missed ./ sum(abs(measured(held_out,2:end)), 1));
)";
  const ChildResult run = RunInOctave(WriteTestFile(trip.folder / "score.m", script));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::istringstream out(run.out);
  std::vector<double> nmae;
  for (double value = 0.0; out >> value;) nmae.push_back(value);
  return nmae;
}

void ExpectScoresOf(const RoundTrip& trip, const std::vector<double>& in_octave) {
  const auto score = JsonOf(trip.score);
  ASSERT_EQ(in_octave.size(), trip.dofs.size());
  for (std::size_t i = 0; i < trip.dofs.size(); ++i) {
    const auto& held_out =
        trip.dofs.size() == 1 ? score["held_out"] : score["dofs"][trip.dofs[i]]["held_out"];
    const double in_fathom = held_out["nmae"];
    EXPECT_GT(in_fathom, 0.003) << trip.dofs[i];
    std::printf(
        "%s: NMAE %.8g in Octave, %.8g in Fathom\n", trip.dofs[i].c_str(), in_octave[i], in_fathom);
    // To three digits and beyond. fathom_simulate steps by up to 0.05 s: of six DOFs 3e-5 remain.
    EXPECT_NEAR(in_octave[i], in_fathom, 1e-4 * in_fathom) << trip.dofs[i];
  }
}

TEST(MssRoundTrip, ScoresInOctaveAsFathomSimulateDoesOfOneDof) {
  if (!HasOctave()) GTEST_SKIP() << "octave-cli is not installed";
  const RoundTrip trip{.dofs = {"surge"}};
  trip.Make("flatfish.yaml", kData + "/experiments/surge_multisine.yaml");
  ExpectScoresOf(trip, NmaeInOctave(trip, 240.0));
}

TEST(MssRoundTrip, ScoresInOctaveAsFathomSimulateDoesOfAVehicleThatTurns) {
  if (!HasOctave()) GTEST_SKIP() << "octave-cli is not installed";
  const RoundTrip trip{.dofs = {"surge", "sway", "yaw"}};
  trip.Make("planar_rov.yaml", kData + "/experiments/film_planar.yaml");
  ExpectScoresOf(trip, NmaeInOctave(trip, 100.0));
}

// Six axes at once for 100 s, with moments that leave the pitch away from 90 degrees, where Euler
// angles fail.
Path GentleSteps(const Path& folder) {
  std::string steps = TextOf(kData + "/experiments/random_steps_rov.yaml");
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at; (at = steps.find(from)) != std::string::npos;) {
      steps.replace(at, from.size(), to);
    }
  };
  replace("duration: 300", "duration: 100");
  replace("held_out: [240, 300]", "held_out: [80, 100]");
  replace("amplitude: 2.5,", "amplitude: 1,");
  return WriteTestFile(folder / "steps.yaml", steps);
}

// Roll, pitch and yaw of the attitude from which fathom_simulate begins the held-out run.
Eigen::Vector3d AnglesAtTheStart(const Path& path) {
  const Log log = ReadLog(path);
  const CoupledData data = CoupledDataOf(log, log.dofs);
  const auto held_out = std::ranges::find(data.segments, true, &CoupledSegment::is_held_out);
  const Eigen::Matrix3d world_from_body =
      Eigen::Quaterniond(MeasuredState(*held_out, 0).attitude).toRotationMatrix();
  return {std::atan2(world_from_body(2, 1), world_from_body(2, 2)),
          -std::asin(world_from_body(2, 0)),
          std::atan2(world_from_body(1, 0), world_from_body(0, 0))};
}

TEST(MssRoundTrip, ScoresInOctaveAsFathomSimulateDoesOfSixDofs) {
  if (!HasOctave()) GTEST_SKIP() << "octave-cli is not installed";
  const RoundTrip trip{.dofs = {"surge", "sway", "heave", "roll", "pitch", "yaw"}};
  trip.Make("bluerov2.yaml", GentleSteps(trip.folder));
  ExpectScoresOf(trip, NmaeInOctave(trip, 80.0, AnglesAtTheStart(trip.log)));
}

}  // namespace
}  // namespace fathom
