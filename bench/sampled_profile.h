// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A part of the work, known by functions on the call stack.
struct ProfileLabel {
  std::string name;                    // "noise fit"
  std::vector<std::string> functions;  // parts of their demangled names: "fathom::FitNoise("
};

// Where a program spends its time: samples of the call stack, evenly over its CPU time. Each
// belongs to the stage whose function stands outermost on the stack and to the kind of work whose
// function stands innermost; to "other" where there is none. Functions must be visible to the
// dynamic linker (CMake's ENABLE_EXPORTS) and not inlined.
//
// One profile at a time, of one thread.
class SampledProfile {
 public:
  SampledProfile(std::vector<ProfileLabel> stages, std::vector<ProfileLabel> kinds);

  void Start();
  void Stop();

  // Seconds of CPU time: a row per stage, a column per kind, then "other" in both.
  std::vector<std::vector<double>> Seconds() const;

  // The same as text, divided by `count`, with sums.
  std::string Table(double count) const;

 private:
  std::vector<ProfileLabel> stages_, kinds_;
  double begin_ = 0.0, duration_ = 0.0;  // of CPU time [s]
};

}  // namespace fathom
