// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/motion/true_run.h"

#include "fathom/base/random_stream.h"
#include "fathom/synthesize/experiment/pid.h"
#include "fathom/synthesize/experiment/resolution.h"

#include <algorithm>
#include <optional>
#include <string>

namespace fathom {
namespace {

// The command of one DOF, from stamp to stamp.
class Driver {
 public:
  Driver(const VehicleMotion& motion,
         const Experiment& experiment,
         const Drive& drive,
         std::uint64_t seed)
      : dof_(drive.dof),
        hidden_(motion.hidden(drive.dof)),
        input_(drive.input),
        resolution_(experiment.command_resolution),
        measurement_(seed, "control." + std::string(Name(dof_))) {
    RandomStream random(seed, "input." + std::string(Name(dof_)));
    DrawRandomParts(input_, LastCommand(motion, experiment), random);
    if (drive.pid) pid_.emplace(*drive.pid, 1.0 / experiment.command_rate);
    if (experiment.pose) {
      noise_ = IsAngular(dof_) ? experiment.pose->angle_noise : experiment.pose->position_noise;
    }
  }

  // [s]
  double Delay() const { return hidden_.Delay(); }

  // The command stamped `stamp`, from the state now.
  double Force(double stamp, const MotionState& state, const Surroundings& now) {
    const double value = Value(input_, stamp);
    if (!pid_) return RoundTo(value, resolution_);
    const double shown = hidden_.Displacement(state.travel[Index(dof_)], InstantsOf(hidden_, now));
    return RoundTo(pid_->Force(value, shown + noise_ * measurement_.Normal()), resolution_);
  }

  // How many commands have been drawn up, and how many have arrived.
  std::size_t num_commands = 0;
  std::size_t num_arrived = 0;

 private:
  Dof dof_;
  const HiddenEffects& hidden_;
  InputSignal input_;
  double resolution_;
  double noise_ = 0.0;
  RandomStream measurement_;
  std::optional<Pid> pid_;
};

// When held forces change: at the stamps, and where commands arrive.
std::vector<double> TimesOfChange(const TrueRun& run,
                                  const std::vector<Driver>& drivers,
                                  double end) {
  std::vector<double> times = run.command_time;
  for (const Driver& driver : drivers) {
    for (const double stamp : run.command_time) {
      const double arrival = stamp + driver.Delay();
      if (0.0 <= arrival && arrival < end) times.push_back(arrival);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

double LastCommand(const VehicleMotion& motion, const Experiment& experiment) {
  double end = experiment.duration;
  for (const Drive& drive : experiment.drives) {
    end = std::max(end, experiment.duration - motion.hidden(drive.dof).Delay());
  }
  return end;
}

std::size_t TrueRun::Before(double t, std::size_t from) const {
  while (from + 1 < time.size() && time[from + 1] <= t) ++from;
  return from;
}

MotionState TrueRun::StateAt(const VehicleMotion& motion, std::size_t place, double t) const {
  return motion.After(states[place], held[place], time[place], t - time[place]);
}

TrueRun DriveThrough(const VehicleMotion& motion,
                     const Experiment& experiment,
                     std::uint64_t seed) {
  std::vector<Driver> drivers;
  std::array<double, 6> initial_speed{};
  for (const Drive& drive : experiment.drives) {
    drivers.emplace_back(motion, experiment, drive, seed);
    initial_speed[Index(drive.dof)] = drive.initial_speed;
  }
  const double end = LastCommand(motion, experiment);
  TrueRun run;
  for (int k = 0; k / experiment.command_rate < end; ++k) {
    run.command_time.push_back(RoundTo(k / experiment.command_rate, kStampResolution));
  }
  run.command.resize(run.command_time.size());

  MotionState state = motion.Start(initial_speed);
  for (const double t : TimesOfChange(run, drivers, end)) {
    if (!run.time.empty()) {
      state = motion.After(state, run.held.back(), run.time.back(), t - run.time.back());
    }
    HeldForces held = run.held.empty() ? HeldForces{} : run.held.back();
    const std::size_t num_sent =
        std::upper_bound(run.command_time.begin(), run.command_time.end(), t) -
        run.command_time.begin();
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      Driver& driver = drivers[i];
      const int dof = Index(experiment.drives[i].dof);
      const double delay = driver.Delay();
      const Surroundings now = {t, state.velocity, held.sent};
      for (std::size_t& k = driver.num_commands;
           k < run.command.size() && run.command_time[k] + std::min(delay, 0.0) <= t;
           ++k) {
        run.command[k][dof] = driver.Force(run.command_time[k], state, now);
      }
      std::size_t& k = driver.num_arrived;
      while (k < run.command.size() && run.command_time[k] + delay <= t) ++k;
      held.arrived[dof] = k > 0 ? run.command[k - 1][dof] : 0.0;
      held.sent[dof] = run.command[num_sent - 1][dof];
    }
    run.time.push_back(t);
    run.states.push_back(state);
    run.held.push_back(held);
  }
  return run;
}

}  // namespace fathom
