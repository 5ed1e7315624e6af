// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/input_reader.h"

#include "fathom/base/files/yaml_numbers.h"

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

class InputReader {
 public:
  InputReader(const YamlMap& map, double command_rate) : map_(map), rate_(command_rate) {}

  InputSignal Read() const {
    InputSignal input;
    input.offset = NumberWithin(map_, "offset", -kLargest, kLargest, 0.0);
    const std::string kind = map_.String("kind");
    if (kind == "sine") {
      input.kind = SineInput{.amplitude = Amplitude(map_, "amplitude"),
                             .frequency = Frequency(map_.Number("frequency")),
                             .phase = NumberWithin(map_, "phase", -kLargest, kLargest, 0.0)};
    } else if (kind == "multisine") {
      input.kind = Multisine();
    } else if (kind == "chirp") {
      const std::vector<double> range = map_.Numbers("frequency", 2);
      input.kind = ChirpInput{.amplitude = Amplitude(map_, "amplitude"),
                              .first_frequency = Frequency(range[0]),
                              .last_frequency = Frequency(range[1]),
                              .sweep = Hold("sweep")};
    } else if (kind == "steps") {
      input.kind = Steps();
    } else if (kind == "prbs") {
      input.kind = PrbsInput{.amplitude = Amplitude(map_, "amplitude"), .hold = Hold("hold")};
    } else if (kind == "square") {
      input.kind = SquareInput{.amplitude = Amplitude(map_, "amplitude"),
                               .frequency = Frequency(map_.Number("frequency"))};
    } else if (kind == "pilot") {
      input.kind = Pilot();
    } else if (kind == "random_steps") {
      input.kind = RandomSteps();
    } else if (kind == "file") {
      input.kind = ReplayInput{.file = map_.String("file"), .command = {}};
    } else {
      map_.Fail("kind",
                fmt::format("is '{}', expected sine, multisine, chirp, steps, prbs, square, pilot, "
                            "random_steps or file.",
                            kind));
    }
    return input;
  }

 private:
  MultisineInput Multisine() const {
    const std::vector<double> range = map_.Numbers("frequency", 2);
    MultisineInput sines;
    sines.rms = Amplitude(map_, "rms");
    sines.lowest_frequency = Frequency(range[0]);
    sines.highest_frequency = Frequency(range[1]);
    if (range[0] > range[1]) {
      map_.Fail("frequency",
                fmt::format("is [{}, {}], expected lowest, highest.", range[0], range[1]));
    }
    const auto num_lines = map_.Integer("lines");
    if (num_lines < 1 || num_lines > 1000) {
      map_.Fail("lines", fmt::format("is {}, expected a whole number from 1 to 1000.", num_lines));
    }
    sines.num_lines = static_cast<int>(num_lines);
    return sines;
  }

  StepsInput Steps() const {
    StepsInput steps{.levels = map_.Numbers("levels"), .hold = Hold("hold")};
    if (steps.levels.empty()) map_.Fail("levels", "is empty, expected at least one level.");
    for (const double level : steps.levels) Within(map_, "levels", level, -kLargest, kLargest);
    return steps;
  }

  PilotInput Pilot() const {
    PilotInput pilot;
    pilot.amplitude = Amplitude(map_, "amplitude");
    pilot.hold = Hold("hold");
    const auto num_levels = map_.Integer("levels");
    if (num_levels < 1 || num_levels > 1000) {
      map_.Fail("levels",
                fmt::format("is {}, expected a whole number from 1 to 1000.", num_levels));
    }
    pilot.num_levels = static_cast<int>(num_levels);
    return pilot;
  }

  RandomStepsInput RandomSteps() const {
    RandomStepsInput random_steps;
    random_steps.amplitude = Amplitude(map_, "amplitude");
    const std::vector<double> hold = map_.Numbers("hold", 2);
    if (hold[0] > hold[1]) {
      map_.Fail("hold", fmt::format("is [{}, {}], expected shortest, longest.", hold[0], hold[1]));
    }
    random_steps.shortest = RequireHold("hold", hold[0]);
    random_steps.longest = RequireHold("hold", hold[1]);
    return random_steps;
  }

  double Frequency(double frequency) const {
    const double highest = std::numbers::pi * rate_;
    if (frequency > 0.0 && frequency < highest) return frequency;
    map_.Fail("frequency",
              fmt::format("holds {} rad/s, expected above 0 and below {:.4g} rad/s, half of the "
                          "command_rate.",
                          frequency,
                          highest));
  }

  double Hold(std::string_view key) const { return RequireHold(key, map_.Number(key)); }

  double RequireHold(std::string_view key, double hold) const {
    if (hold * rate_ >= 1.0 - 1e-9 && hold <= kLargest) return hold;
    map_.Fail(key,
              fmt::format("is {} s, expected at least one period of the command_rate, {:.4g} s.",
                          hold,
                          1.0 / rate_));
  }

  const YamlMap& map_;
  double rate_;
};

}  // namespace

InputSignal ReadInput(const YamlMap& map, double command_rate) {
  return InputReader(map, command_rate).Read();
}

}  // namespace fathom
