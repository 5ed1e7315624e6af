// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/random_stream.h"
#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::hidden {

// Uniform numbers of one purpose, with the shapes that are needed here.
class Chance {
 public:
  Chance(std::uint64_t seed, std::string_view purpose) : random_(seed, purpose) {}

  double Uniform(double low, double high) { return low + (high - low) * random_.Uniform(); }
  double LogUniform(double low, double high);
  bool Is(double probability) { return random_.Uniform() < probability; }
  double Sign() { return Is(0.5) ? 1.0 : -1.0; }
  int Index(int count) { return static_cast<int>(count * random_.Uniform()); }
  template <typename T>
  T OneOf(const std::vector<T>& choices) {
    return choices[Index(static_cast<int>(choices.size()))];
  }

 private:
  RandomStream random_;
};

// Who moves, and what must be there for what is hidden to leave a trace.
struct Cast {
  Dof dof = Dof::kSurge;
  std::vector<Dof> partners;
  bool needs_pose = false;
};

// A vehicle, what is done with it, and how it is measured.
struct Setup {
  Cast cast;
  Vehicle vehicle;
  Experiment experiment;
  double damping_rate = 0.1;        // of the DOF about its motion [1/s]
  bool poses_show_the_dof = false;  // there are poses, and nothing turns the DOF's axis
  bool has_outliers = false;
  std::string text;  // for people
};

// A vehicle within half an order of magnitude about FlatFish; open-loop inputs of any kind that
// move it at 0.1 to 0.7 m/s RMS, 120 to 600 s, 5 to 50 Hz.
Setup DrawSetup(const Cast& cast, std::uint64_t seed);

}  // namespace fathom::hidden
