// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Six DOFs and 30 numbers over 300 s at 50 Hz: a simulation with all sensitivities against the same
// by hand in C, in one run; the times of a fit and of a ladder, and how a fit grows to 3000 s. Exit
// 1 if a limit is broken. Times are the best of several repetitions. docs/coupled.md.

#include "fathom/coupled/coupled_fit.h"
#include "fathom/coupled/structure_ladder.h"
#include "fathom/simulate/coupled/coupled_simulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "best_times.h"
#include "coupled_by_hand.h"
#include <benchmark/benchmark.h>

namespace fathom {
namespace {

constexpr double kStep = 0.02;  // [s]

CoupledModel Truth() {
  CoupledModel model;
  model.dofs.assign(kAllDofs.begin(), kAllDofs.end());
  model.inertia.diagonal() << 40.0, 60.0, 70.0, 4.0, 5.0, 6.0;
  model.inertia(0, 2) = model.inertia(2, 0) = 3.0;
  model.inertia(0, 4) = model.inertia(4, 0) = 1.5;
  model.inertia(1, 3) = model.inertia(3, 1) = -1.5;
  model.inertia(1, 5) = model.inertia(5, 1) = 2.0;
  model.linear_damping.diagonal() << 8.0, 12.0, 14.0, 2.0, 2.5, 3.0;
  model.quadratic_damping.diagonal() << 30.0, 60.0, 70.0, 3.0, 4.0, 5.0;
  model.offset << 0.3, -0.4, 0.0, 0.1, -0.1, 0.05;
  model.net_buoyancy = 2.0;
  model.righting_roll = 6.0;
  model.righting_pitch = 7.0;
  model.coriolis = true;
  return model;
}

MotionStructure Structure() {
  MotionStructure structure = StructureOf(StandardStructure::kCoriolis, Truth().dofs);
  for (const auto& [a, b] : {std::pair{Dof::kSurge, Dof::kHeave},
                             {Dof::kSurge, Dof::kPitch},
                             {Dof::kSway, Dof::kRoll},
                             {Dof::kSway, Dof::kYaw}}) {
    structure.entries.push_back(InertiaEntry(a, b));
  }
  return structure;
}

CoupledCommand Command(int num_samples) {
  const Vector6 size(15.0, 20.0, 20.0, 1.5, 2.0, 3.0);
  CoupledCommand command;
  for (int i = 0; i < num_samples; ++i) {
    const double t = kStep * i;
    command.time.push_back(t);
    Vector6& force = command.force.emplace_back();
    for (int dof = 0; dof < 6; ++dof) {
      const double tone = 1.0 + 0.13 * dof;
      force[dof] = size[dof] * (std::sin(0.11 * tone * t + dof) + std::sin(0.43 * tone * t) +
                                std::sin(1.3 * tone * t + 2.0 * dof));
    }
  }
  return command;
}

CoupledStamps Stamps(const std::vector<double>& time) { return {time.front(), time, time}; }

// Velocities with noise of 0.01 m/s and 0.005 rad/s, attitudes with 0.005 rad.
CoupledData MakeData(double duration) {
  CoupledData data;
  data.log = "bench";
  data.dofs = Truth().dofs;
  data.force_unit = "N";
  data.has_velocity.fill(true);
  data.has_attitude = true;
  data.inputs.command = Command(static_cast<int>(std::lround(duration / kStep)));
  CoupledSegment& segment = data.segments.emplace_back();
  segment.time = segment.pose_time = data.inputs.command.time;
  CoupledOutputs outputs;
  RunCoupled(Truth(), data.inputs, {}, Stamps(segment.time), &outputs);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < segment.time.size(); ++i) {
    Vector6& velocity = segment.velocity.emplace_back(outputs.velocity[i]);
    for (int dof = 0; dof < 6; ++dof) velocity[dof] += (dof < 3 ? 0.01 : 0.005) * normal(random);
    const Eigen::Vector3d turn(normal(random), normal(random), normal(random));
    Eigen::Quaterniond noise(1.0, 0.0025 * turn[0], 0.0025 * turn[1], 0.0025 * turn[2]);
    segment.attitude.push_back((Eigen::Quaterniond(outputs.pose[i].attitude) * noise).normalized());
    segment.position.push_back(outputs.pose[i].position);
  }
  return data;
}

// The same as a program by hand has it.
struct ByHand {
  HandModel model = {};
  std::vector<HandEntry> entries;
  std::vector<HandSample> samples;

  explicit ByHand(std::size_t num_samples) : samples(num_samples) {
    const CoupledModel truth = Truth();
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        model.inertia[i][j] = truth.inertia(i, j);
        model.linear_damping[i][j] = truth.linear_damping(i, j);
        model.quadratic_damping[i][j] = truth.quadratic_damping(i, j);
      }
      model.offset[i] = truth.offset[i];
    }
    model.net_buoyancy = truth.net_buoyancy;
    model.righting_roll = truth.righting_roll;
    model.righting_pitch = truth.righting_pitch;
    for (const FreeEntry& entry : Structure().entries) {
      entries.push_back({KindOf(entry), Index(entry.row), Index(entry.column)});
    }
  }

  static HandKind KindOf(const FreeEntry& entry) {
    using Kind = FreeEntry::Kind;
    switch (entry.kind) {
      case Kind::kInertia:
        return HAND_INERTIA;
      case Kind::kLinearDamping:
        return HAND_LINEAR_DAMPING;
      case Kind::kQuadraticDamping:
        return HAND_QUADRATIC_DAMPING;
      case Kind::kNetBuoyancy:
        return HAND_NET_BUOYANCY;
      case Kind::kRightingMoment:
        return entry.row == Dof::kRoll ? HAND_RIGHTING_ROLL : HAND_RIGHTING_PITCH;
      default:
        return HAND_OFFSET;
    }
  }

  bool Simulate(const std::vector<Vector6>& force) {
    return HandSimulate(&model,
                        entries.data(),
                        reinterpret_cast<const double(*)[6]>(force.data()),
                        static_cast<int>(force.size()),
                        kStep,
                        samples.data()) != 0;
  }
};

// The largest difference of a sensitivity, in shares of the largest of its row.
double Difference(const ByHand& peer, const CoupledOutputs& outputs) {
  double largest = 0.0;
  for (std::size_t n = 0; n < peer.samples.size(); ++n) {
    for (int i = 0; i < 12; ++i) {
      const auto& sensitivity = i < 6 ? outputs.velocity_sensitivity : outputs.pose_sensitivity;
      const auto ours = sensitivity.row(6 * static_cast<Eigen::Index>(n) + i % 6);
      const auto row =
          Eigen::Map<const Eigen::Matrix<double, 1, HAND_COLUMNS>>(peer.samples[n].tangent.row[i]);
      largest = std::max(
          largest, (ours - row).cwiseAbs().maxCoeff() / std::max(row.cwiseAbs().maxCoeff(), 1e-3));
    }
  }
  return largest;
}

void FathomSensitivities(benchmark::State& state) {
  const CoupledData data = MakeData(300.0);
  const CoupledModel truth = Truth();
  const MotionStructure structure = Structure();
  const CoupledStamps stamps = Stamps(data.segments.front().time);
  CoupledOutputs outputs;
  for (auto _ : state) {
    if (!RunCoupledWithSensitivities(truth, structure.entries, data.inputs, {}, stamps, &outputs)) {
      state.SkipWithError("the run diverges");
    }
  }
  ByHand peer(stamps.velocity.size());
  peer.Simulate(data.inputs.command.force);
  const double difference = Difference(peer, outputs);
  state.counters["difference"] = difference;
  if (!(difference < 1e-9)) state.SkipWithError("the two simulations differ");
}

void PeerSensitivities(benchmark::State& state) {
  const CoupledData data = MakeData(300.0);
  ByHand peer(data.segments.front().time.size());
  for (auto _ : state) {
    if (!peer.Simulate(data.inputs.command.force)) state.SkipWithError("no inertia");
  }
}

void FathomFit(benchmark::State& state) {
  const std::vector<CoupledData> logs = {MakeData(static_cast<double>(state.range(0)))};
  const MotionStructure structure = Structure();
  for (auto _ : state) {
    const CoupledSummary summary = FitCoupled(logs, structure);
    if (!summary.IsUsable()) state.SkipWithError(summary.message.c_str());
    state.counters["inertia"] = summary.model.inertia(0, 0);
    state.counters["iterations"] = summary.num_iterations;
  }
}

// The structure, chosen.
void FathomLadder(benchmark::State& state) {
  CoupledLogs logs;
  logs.data = {MakeData(300.0)};
  for (auto _ : state) {
    const Ladder ladder = ClimbLadder(logs, Truth().dofs, {});
    const LadderRung& accepted = ladder.rungs[ladder.accepted];
    if (!accepted.fit.IsUsable()) state.SkipWithError(accepted.fit.message.c_str());
    state.counters["named"] = static_cast<double>(ladder.named.size());
    state.counters["inertia"] = accepted.fit.model.inertia(0, 0);
  }
}

constexpr double kMostOfPeer = 1.5;        // times its CPU time
constexpr double kMostOfFit = 1000.0;      // [ms]
constexpr double kMostOfLadder = 20000.0;  // [ms]
constexpr double kMostGrowth = 12.0;       // for ten times the data

BENCHMARK(FathomSensitivities)->Unit(benchmark::kMillisecond)->Repetitions(7)->MinTime(0.2);
BENCHMARK(PeerSensitivities)->Unit(benchmark::kMillisecond)->Repetitions(7)->MinTime(0.2);
// Of all threads.
BENCHMARK(FathomFit)
    ->Arg(300)
    ->Arg(3000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->Repetitions(2);
BENCHMARK(FathomLadder)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(1);

bool PrintLimits(const BestTimes& times) {
  std::printf("\nThe best CPU times\n");
  bool is_kept = times.PrintRatio("FathomSensitivities", "PeerSensitivities", kMostOfPeer);
  is_kept = times.PrintTime("FathomFit/300", kMostOfFit) && is_kept;
  is_kept = times.PrintTime("FathomLadder", kMostOfLadder) && is_kept;
  return times.PrintRatio("FathomFit/3000", "FathomFit/300", kMostGrowth) && is_kept;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::BestTimes times;
  fathom::RunBenchmarks(argc, argv, &times);
  const bool is_kept = fathom::PrintLimits(times);
  if (times.has_failed()) std::fprintf(stderr, "coupled_bench: a run failed.\n");
  if (!is_kept) std::fprintf(stderr, "coupled_bench: a limit is broken, see above.\n");
  return is_kept && !times.has_failed() ? 0 : 1;
}
