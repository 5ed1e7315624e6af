// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/screen/starts.h"
#include "fathom/diagnosis/search/search_task.h"

#include <memory>
#include <optional>
#include <vector>

namespace fathom {

// Which noises a hypothesis is screened under.
enum class Sharpness {
  kOwn,         // the noise that is given
  kWithSensor,  // and a sensor's alone: there nothing that is missing passes for a disturbance
};

// Every suspect beside one hypothesis. Neither screen is there where nothing can be tried.
struct Screens {
  std::optional<Starts> own;    // under the noise that was given
  std::optional<Starts> sharp;  // under a sensor's noise alone, if asked for

  // Best score of each suspect on either screen, the sharper one scaled to the other.
  std::vector<double> scores;
};

Screens ScreensAbout(const SearchTask& task,
                     const std::shared_ptr<const FitAndTrials>& about,
                     const NoiseModel& noise,
                     Sharpness sharpness);

// A fit with all trials about it.
std::shared_ptr<const FitAndTrials> WithTrials(const SearchTask& task, const StructureFit& fit);

// Suspects, the best score first.
std::vector<int> InOrder(const std::vector<double>& scores);

}  // namespace fathom
