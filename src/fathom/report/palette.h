// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Measured data, and a lone curve that belongs to no family.
inline constexpr std::string_view kMeasuredColor = "#8d96a3";
inline constexpr std::string_view kLoneColor = "#57606e";

// Colours that people with any kind of colour vision tell apart (Okabe and Ito, 2008, without its
// yellow, which is too pale for lines), handed out by name in the order in which names first
// appear.
class Palette {
 public:
  // "#0072b2"; the eighth name gets the first colour again.
  std::string_view ColorOf(const std::string& name);

 private:
  std::vector<std::string> names_;
};

}  // namespace fathom
