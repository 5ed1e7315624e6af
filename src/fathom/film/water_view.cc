// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/water_view.h"

#include <fmt/format.h>

namespace fathom {

std::vector<std::string> WaterView::Problems() const {
  std::vector<std::string> problems;
  const auto require = [&](bool rule, const char* name, double value, const char* expected) {
    if (!rule) problems.push_back(fmt::format("{} is {}, expected {}", name, value, expected));
  };
  const auto is_grey = [](double value) { return value >= 0.0 && value <= 255.0; };
  require(is_grey(white), "white", white, "0 to 255");
  require(is_grey(black), "black", black, "0 to 255");
  require(is_grey(wall), "wall", wall, "0 to 255");
  require(attenuation >= 0.0 && attenuation <= 100.0, "attenuation", attenuation, "0 to 100 1/m");
  require(is_grey(veiling_light), "veiling_light", veiling_light, "0 to 255");
  require(vignetting >= 0.0 && vignetting <= 1.0, "vignetting", vignetting, "0 to 1");
  require(blur >= 0.0 && blur <= 20.0, "blur", blur, "0 to 20 px");
  require(noise >= 0.0 && noise <= 255.0, "noise", noise, "0 to 255");
  require(shot_noise >= 0.0 && shot_noise <= 255.0, "shot_noise", shot_noise, "0 to 255");
  return problems;
}

}  // namespace fathom
