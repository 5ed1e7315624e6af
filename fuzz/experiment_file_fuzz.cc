// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as an experiment file; what is read and is not too long must then make a log of finite
// numbers.

#include "fathom/base/input_error.h"
#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <variant>

namespace {

void RequireFinite(const std::optional<fathom::Stream>& stream) {
  if (!stream) return;
  for (std::size_t i = 1; i < stream->time.size(); ++i) {
    if (!(stream->time[i - 1] < stream->time[i])) std::abort();
  }
  for (const auto& column : stream->values) {
    for (const double value : column) {
      if (!std::isfinite(value)) std::abort();
    }
  }
}

double HighestRate(const fathom::Experiment& experiment) {
  double rate = experiment.command_rate;
  if (experiment.velocity) rate = std::max(rate, experiment.velocity->sampling.rate);
  if (experiment.pose) rate = std::max(rate, experiment.pose->sampling.rate);
  return rate;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    auto experiment =
        fathom::ParseExperiment("e.yaml", std::string(reinterpret_cast<const char*>(data), size));
    if (experiment.duration > 20.0 || experiment.duration * HighestRate(experiment) > 300.0) {
      return 0;
    }
    fathom::Vehicle vehicle;
    for (auto& model : vehicle.models) model = {40.0, 30.0, 5.0, -1.0};
    for (auto& drive : experiment.drives) {
      if (auto* replay = std::get_if<fathom::ReplayInput>(&drive.input.kind)) {
        replay->command = {{0.0, 1.0}, {10.0, -3.0}};
      }
    }
    const auto log = fathom::Synthesize(vehicle, experiment, 1);
    RequireFinite(log.command);
    RequireFinite(log.velocity);
    RequireFinite(log.pose);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
