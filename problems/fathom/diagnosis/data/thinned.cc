// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/thinned.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <memory>
#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kJump = 0.1;      // of the RMS command
constexpr double kSlack = 1e-6;    // [s], of stamps
constexpr double kSlow = 0.1;      // rate times step: a second-order step errs by less than 1e-3
constexpr double kWorthIt = 1.25;  // so many to one, at least

// True if `time` has so many stamps that averaging over a `width` [s] is worth it.
bool IsFast(const std::vector<double>& time, double width) {
  if (time.size() < 2) return false;
  const double usual = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  return usual * kWorthIt < width;
}

// Each value weighs by how long it was held. No mean is taken over a jump: the vehicle's speed
// bends just there.
HeldCommand Averaged(const HeldCommand& command, double width) {
  HeldCommand averaged;
  const size_t n = command.time.size();
  const Eigen::Map<const Eigen::ArrayXd> values(command.value.data(), std::ssize(command.value));
  const double jump = kJump * std::sqrt(values.square().mean());
  const auto joins = [&](size_t begin, size_t i) {
    return command.time[i] - command.time[begin] < width - kSlack &&
           std::abs(command.value[i] - command.value[i - 1]) <= jump;
  };
  for (size_t begin = 0; begin < n;) {
    size_t end = begin + 1;
    double impulse = 0.0;
    for (; end < n && joins(begin, end); ++end) {
      impulse += command.value[end - 1] * (command.time[end] - command.time[end - 1]);
    }
    // The last value of the group is held until the next group begins; that of the run for ever.
    averaged.time.push_back(command.time[begin]);
    if (end < n && command.time[end] - command.time[begin] < 2.0 * width) {
      impulse += command.value[end - 1] * (command.time[end] - command.time[end - 1]);
      averaged.value.push_back(impulse / (command.time[end] - command.time[begin]));
    } else if (end - begin == 1) {
      averaged.value.push_back(command.value[begin]);
    } else {
      // A silence follows: what is held through it stands alone.
      averaged.value.push_back(impulse / (command.time[end - 1] - command.time[begin]));
      averaged.time.push_back(command.time[end - 1]);
      averaged.value.push_back(command.value[end - 1]);
    }
    begin = end;
  }
  return averaged;
}

// All that belongs to the stamps, the stamps among it; what is empty stays so.
void Average(double width,
             std::vector<double>* time,
             std::initializer_list<std::vector<double>*> values) {
  if (!IsFast(*time, width)) return;
  std::vector<size_t> begins;
  for (size_t i = 0; i < time->size(); ++i) {
    const bool joins = !begins.empty() && (*time)[i] - (*time)[begins.back()] < width - kSlack;
    if (!joins) begins.push_back(i);
  }
  begins.push_back(time->size());
  const auto average = [&](std::vector<double>* value) {
    if (value->empty()) return;
    std::vector<double> means;
    for (size_t k = 0; k + 1 < begins.size(); ++k) {
      double sum = 0.0;
      for (size_t i = begins[k]; i < begins[k + 1]; ++i) sum += (*value)[i];
      means.push_back(sum / static_cast<double>(begins[k + 1] - begins[k]));
    }
    *value = std::move(means);
  };
  for (std::vector<double>* value : values) average(value);
  average(time);
}

}  // namespace

std::vector<MeasuredSegment> Thinned(const std::vector<MeasuredSegment>& segments, double width) {
  struct ThinnedInputs {
    std::shared_ptr<const EffectInputs> inputs;
    Tone command_tone;
  };
  std::map<const EffectInputs*, ThinnedInputs> thinned_inputs;
  std::vector<MeasuredSegment> thinned = segments;
  for (MeasuredSegment& segment : thinned) {
    if (IsFast(segment.inputs->command.time, width)) {
      auto& [inputs, command_tone] = thinned_inputs[segment.inputs.get()];
      if (!inputs) {
        EffectInputs copy = *segment.inputs;
        copy.command = Averaged(copy.command, width);
        if (width > kFineWidth) copy.steps = {std::max(copy.steps.longest, 2.0 * width), kSlow};
        command_tone = DominantTone(copy.command);
        inputs = std::make_shared<const EffectInputs>(std::move(copy));
      }
      segment.inputs = inputs;
      segment.command_tone = command_tone;
    }
    Average(width, &segment.stamps.velocity, {&segment.velocity});
    Average(width,
            &segment.stamps.displacement,
            {&segment.displacement, &segment.displacement_variance});
  }
  return thinned;
}

}  // namespace fathom
