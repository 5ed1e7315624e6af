// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "small_log.h"

namespace fathom {

// Makes a log of the vehicle under the experiment with `effects` hidden, and gives its path back.
std::filesystem::path Synthesized(const std::filesystem::path& vehicle,
                                  const std::filesystem::path& experiment,
                                  const std::string& effects,
                                  int seed,
                                  const std::filesystem::path& log);

// A minute and a half of a vehicle, by default that of small_log.h, under a multisine of 12 N rms
// in `folder`/`name`: quickly diagnosed. Speeds at 10 Hz with noise of 5 mm/s; held out from 70 s
// on.
std::filesystem::path SmallLogWith(const std::filesystem::path& folder,
                                   const std::string& name,
                                   const std::string& effects,
                                   int seed,
                                   const std::string& vehicle_yaml = SmallVehicleYaml());

// The same, but the effects act in the training data alone: no model that has them predicts what is
// held out.
std::filesystem::path SmallLogThatLoses(const std::filesystem::path& folder,
                                        const std::string& effects,
                                        int seed);

}  // namespace fathom
