// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "checked_dive.h"

#include <algorithm>
#include <cmath>

#include "saved_files.h"
#include "sound_log.h"
#include <fmt/format.h>

namespace fathom {
namespace {

using Json = nlohmann::json;
using Path = std::filesystem::path;

void Drive(LogNumbers* log, const std::function<double(double, double)>& force) {
  double v = 0.0;
  std::size_t row = 0;
  const std::vector<double> noise = log->speed;  // its last digits are as good as noise
  log->force.clear();
  log->command_time.clear();
  for (double t = 0.0; t < 150.0; t += 0.1) {
    const double measured = v + 0.002 * std::sin(1e4 * noise[std::min(row, noise.size() - 1)]);
    const double f = force(t, measured);
    log->command_time.push_back(t);
    log->force.push_back(f);
    while (row < log->time.size() && log->time[row] < t + 0.1) {
      log->speed[row++] = measured;
    }
    v += 0.1 * (f - 40.0 * v * std::abs(v) - 8.0 * v + 0.3) / 38.0;
  }
}

}  // namespace

Dive SoundDive(const Path& scratch, bool is_slow) {
  Dive dive;
  dive.numbers = is_slow ? SlowSoundLog(scratch) : SoundLog(scratch);
  double x = 0.0;
  for (std::size_t i = 0; i < dive.numbers.time.size(); ++i) {
    if (i > 0) {
      x += 0.5 * (dive.numbers.speed[i] + dive.numbers.speed[i - 1]) *
           (dive.numbers.time[i] - dive.numbers.time[i - 1]);
    }
    dive.x.push_back(x);
    dive.y.push_back(0.0);
    dive.yaw.push_back(0.0);
  }
  return dive;
}

Path WriteDive(const Dive& dive, const Path& folder) {
  Write(dive.numbers, folder);
  if (!dive.has_pose) return folder;
  std::string pose = "t,x,y,z,qx,qy,qz,qw\n";
  for (std::size_t i = 0; i < dive.x.size(); ++i) {
    pose += fmt::format("{},{:.7g},{:.7g},0,0,0,{:.9f},{:.9f}\n",
                        dive.numbers.time[i],
                        dive.x[i],
                        dive.y[i],
                        std::sin(0.5 * dive.yaw[i]),
                        std::cos(0.5 * dive.yaw[i]));
  }
  WriteTestFile(folder / "pose.csv", pose);
  return folder;
}

Said Check(const Path& log, const Path& scratch) {
  const Path file = scratch / "check.json";
  const ToolRun run = RunToolBinary("fathom_check", {Flag("log", log), Flag("json", file)});
  Said said = {run.exit_code, {}, "", run.out + run.err};
  if (run.exit_code != 0 && run.exit_code != 2) return said;
  const Json json = Json::parse(TextOf(file));
  for (const Json& finding : json["findings"]) said.findings.push_back(finding);
  for (const Json& dof : json["dofs"]) {
    for (const Json& finding : dof["findings"]) said.findings.push_back(finding);
    said.why_not += dof["why_not"].get<std::string>();
  }
  return said;
}

std::function<void(Dive*)> Later(double seconds) {
  return [=](Dive* dive) {
    for (double& t : dive->numbers.time) t += seconds;
  };
}

std::function<void(Dive*)> Pose(const std::function<void(Dive*, std::size_t)>& change) {
  return [=](Dive* dive) {
    dive->has_pose = true;
    for (std::size_t i = 0; i < dive->x.size(); ++i) change(dive, i);
  };
}

std::function<void(Dive*)> Driven(const std::function<double(double, double)>& force) {
  return [=](Dive* dive) { Drive(&dive->numbers, force); };
}

double Tones(double t) {
  return 12.0 * std::sin(0.6 * t) + 9.0 * std::sin(1.7 * t + 1.0) + 7.0 * std::sin(4.1 * t);
}

}  // namespace fathom
