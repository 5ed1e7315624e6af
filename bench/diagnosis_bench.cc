// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Diagnose() over 300 s at 50 Hz with every candidate that the log allows, on one core: with
// nothing hidden, with one cause, with two; seconds per log, and where they go. docs/diagnosis.md.

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/synthesize/effects/parse_hidden_effects.h"
#include "fathom/synthesize/synthesize.h"

#include <cstdio>
#include <string>
#include <vector>

#include "sampled_profile.h"
#include <benchmark/benchmark.h>

namespace fathom {
namespace {

Vehicle FlatFish() {
  Vehicle vehicle;
  vehicle.name = "flatfish";
  vehicle.models[Index(Dof::kSurge)] = {890.0, 60.0, 39.0, -0.8};
  vehicle.models[Index(Dof::kSway)] = {1300.0, 400.0, 60.0, 0.0};
  vehicle.models[Index(Dof::kHeave)] = {1500.0, 1900.0, 31.0, 0.0};
  vehicle.models[Index(Dof::kYaw)] = {300.0, 280.0, 27.0, 0.0};
  return vehicle;
}

Drive Sines(Dof dof, double rms, double lowest, double highest) {
  MultisineInput sines;
  sines.rms = rms;
  sines.lowest_frequency = lowest;
  sines.highest_frequency = highest;
  sines.num_lines = 12;
  Drive drive;
  drive.dof = dof;
  drive.input = {0.0, sines};
  return drive;
}

// 300 s at 50 Hz of surge, with two other DOFs that move a little. Yaw is one of them only where
// there are no poses: it would turn the axis along which they are taken.
Experiment Run(bool with_poses) {
  Experiment experiment;
  experiment.name = "bench";
  experiment.duration = 300.0;
  experiment.command_rate = 50.0;
  experiment.drives = {
      Sines(Dof::kSurge, 30.0, 0.06, 1.6),
      Sines(Dof::kSway, 30.0, 0.1, 1.0),
      with_poses ? Sines(Dof::kHeave, 40.0, 0.2, 1.5) : Sines(Dof::kYaw, 6.0, 0.5, 1.5)};
  experiment.velocity.emplace();
  experiment.velocity->sampling.rate = 50.0;
  experiment.velocity->noise = {0.01, 0.01, 0.01, 0.0, 0.0, 0.002};
  if (with_poses) {
    experiment.pose.emplace();
    experiment.pose->sampling.rate = 50.0;
    experiment.pose->position_noise = 0.01;
    experiment.pose->angle_noise = 0.002;
  }
  return experiment;
}

Log LogWith(const std::string& effects, bool with_poses) {
  const Vehicle vehicle = FlatFish();
  const Experiment experiment = Run(with_poses);
  const auto scales = ScalesOf(vehicle, experiment, 1);
  const std::vector<ActiveEffect> hidden = effects.empty()
                                               ? std::vector<ActiveEffect>()
                                               : ParseHiddenEffects(effects, experiment, scales, 1);
  return Synthesize(vehicle, experiment, hidden, 1);
}

SampledProfile NewProfile() {
  return SampledProfile(
      {{"start, outliers", {"MeasuredSegmentsOf(", "FindRobustStart(", "RemoveOutliers("}},
       {"baseline fit", {"FitBaseline("}},
       {"search", {"SearchCauses("}},
       {"remaining structure", {"FindRemainingStructure("}},
       {"missing force, traces", {"FindMissingForce(", "TraceOf("}},
       {"held-out", {"fathom::FitStructure(", "FreeRunOver(", "GainOf("}}},
      {{"noise fits", {"fathom::FitNoise("}},
       {"screen", {"TrialsAbout(", "fathom::Screen::"}},
       {"derivatives", {"TrainingData::Linearise(", "RunWithSensitivities("}},
       {"simulation", {"TrainingData::Simulate("}},
       {"whitening", {"Whitener::"}},
       {"fits' algebra", {"fathom::FitStructure("}}});
}

void DiagnoseLog(benchmark::State& state, const std::string& effects, bool with_poses) {
  const std::vector<Log> logs = {LogWith(effects, with_poses)};
  Diagnosis diagnosis;
  SampledProfile profile = NewProfile();
  profile.Start();
  for (auto _ : state) diagnosis = Diagnose(logs, Dof::kSurge);
  profile.Stop();
  std::string named;
  for (const Cause& cause : diagnosis.causes) {
    named +=
        " " + std::string(diagnosis.extended.model.effects[cause.effect_index].effect->info().name);
  }
  state.SetLabel(std::string(Name(diagnosis.verdict)) + named);
  state.counters["candidates"] = static_cast<double>(diagnosis.candidates.size());
  std::fprintf(stderr, "\n%s", profile.Table(static_cast<double>(state.iterations())).c_str());
}

void RegisterAll() {
  const struct {
    const char *name, *effects;
  } cases[] = {{"nothing", ""},
               {"lag", "thruster_lag:time_constant=0.4"},
               {"dead_zone_and_step", "thrust_dead_zone:width=6,buoyancy_step:jump=5:time=160"}};
  for (const bool with_poses : {false, true}) {
    for (const auto& each : cases) {
      const std::string name =
          std::string(with_poses ? "velocity_and_poses/" : "velocity/") + each.name;
      benchmark::RegisterBenchmark(
          name.c_str(),
          [effects = std::string(each.effects), with_poses](benchmark::State& state) {
            DiagnoseLog(state, effects, with_poses);
          })
          ->Unit(benchmark::kSecond)
          ->MeasureProcessCPUTime()
          ->Iterations(1);
    }
  }
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  fathom::RegisterAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
