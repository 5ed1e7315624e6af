// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <filesystem>
#include <string>

#include "run_tool.h"

namespace fathom {

// A turn of 0.7 rad/s that decays by 0.2 1/s and 0.48 per rad, with a ripple in place of noise;
// with no decay it goes on for ever.
inline std::filesystem::path TurnWithoutCommand(const std::filesystem::path& folder, bool decays) {
  std::string text = "t,v\n";
  const double a = 0.2, b = 0.48, v0 = 0.7;
  for (int i = 0; i < 300; ++i) {
    const double t = 0.05 * i, e = std::exp(-a * t);
    const double v = decays ? a * v0 * e / (a + b * v0 * (1.0 - e)) : v0;
    text += std::to_string(t) + "," + std::to_string(v + 0.002 * std::sin(40.0 * t)) + "\n";
  }
  return WriteTestFile(folder / "turn.csv", text);
}

}  // namespace fathom
