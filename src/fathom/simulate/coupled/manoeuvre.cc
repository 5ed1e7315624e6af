// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/manoeuvre.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"

#include <cstddef>
#include <numbers>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

[[noreturn]] void RefuseManoeuvre(std::string_view text) {
  throw InputError(fmt::format(
      "{} is no manoeuvre, expected turning_circle:35 (degrees of the rudder), zigzag:10/10 "
      "(degrees of rudder and heading), stop, stop:50 (per cent of the thrust, astern), spiral:25 "
      "or "
      "pull_out:20 (degrees of the rudder).",
      Quoted(std::string(text))));
}

// Degrees to radians.
double AngleIn(std::string_view text, std::string_view whole) {
  const auto degrees = ParseFiniteNumber(text);
  if (!degrees) RefuseManoeuvre(whole);
  if (!(*degrees > 0.0 && *degrees < 90.0)) {
    throw InputError(
        fmt::format("{}: the angle is {:g} degrees, expected more than 0 and less than "
                    "90.",
                    Quoted(std::string(whole)),
                    *degrees));
  }
  return *degrees * std::numbers::pi / 180.0;
}

double ShareIn(std::string_view text, std::string_view whole) {
  const auto per_cent = ParseFiniteNumber(text);
  if (!per_cent) RefuseManoeuvre(whole);
  if (!(*per_cent >= 0.0 && *per_cent <= 1000.0)) {
    throw InputError(fmt::format("{}: the thrust astern is {:g} per cent, expected 0 to 1000.",
                                 Quoted(std::string(whole)),
                                 *per_cent));
  }
  return *per_cent / 100.0;
}

// Takes the minus of "-35" away and tells the side.
double TakeSide(std::string_view* text) {
  if (!text->starts_with('-')) return 1.0;
  text->remove_prefix(1);
  return -1.0;
}

}  // namespace

Manoeuvre ParseManoeuvre(std::string_view text) {
  const std::size_t colon = text.find(':');
  const bool is_bare = colon == std::string_view::npos;
  const std::string_view name = text.substr(0, colon);
  std::string_view rest = is_bare ? "" : text.substr(colon + 1);
  Manoeuvre manoeuvre;
  if (name == "stop") {
    manoeuvre.kind = Manoeuvre::Kind::kStop;
    manoeuvre.astern = is_bare ? 1.0 : ShareIn(rest, text);
    return manoeuvre;
  }
  if (name == "spiral" || name == "pull_out") {
    const bool is_spiral = name == "spiral";
    manoeuvre.kind = is_spiral ? Manoeuvre::Kind::kSpiral : Manoeuvre::Kind::kPullOut;
    if (is_bare) rest = is_spiral ? "25" : "20";
    manoeuvre.angle = AngleIn(rest, text);
    return manoeuvre;
  }
  manoeuvre.first_side = TakeSide(&rest);
  if (name == "turning_circle") {
    manoeuvre.angle = AngleIn(rest, text);
    return manoeuvre;
  }
  const std::size_t slash = rest.find('/');
  if (name != "zigzag" || slash == std::string_view::npos) RefuseManoeuvre(text);
  manoeuvre.kind = Manoeuvre::Kind::kZigzag;
  manoeuvre.angle = AngleIn(rest.substr(0, slash), text);
  manoeuvre.heading = AngleIn(rest.substr(slash + 1), text);
  return manoeuvre;
}

}  // namespace fathom
