// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/input_error.h"
#include "fathom/base/time_interval.h"
#include "fathom/log/correction.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fathom {

// parse(text), with the argument's name before what it says of a text that it cannot use.
template <typename Parse>
auto ParseArgument(const std::string& argument, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const InputError& error) {
    throw InputError(argument + ": " + error.what());
  }
}

// What a list of names stands for, each once.
template <typename T>
std::vector<T> ParseList(const std::string& argument,
                         const std::vector<std::string>& names,
                         T (*parse)(const std::string&)) {
  std::vector<T> list;
  for (const std::string& name : names) {
    const T one = ParseArgument(argument, name, parse);
    for (const T& other : list) {
      if (other != one) continue;
      throw InputError(argument + ": names " + name + " twice, expected each once.");
    }
    list.push_back(one);
  }
  return list;
}

using Pairs = std::vector<std::pair<double, double>>;

// Throws InputError if one does not end after it begins.
std::vector<TimeInterval> HeldOutOf(const Pairs& pairs);

// "240:300,400:420", as --held_out takes them.
std::string HeldOutText(const Pairs& pairs);

using NumberByColumn = std::map<std::string, double>;

// Of columns of velocity.csv, as log.yaml has them under the same keys. Throws InputError for what
// is not finite, and for a factor of 0.
std::vector<Correction> CorrectionsOf(const NumberByColumn& correct, const NumberByColumn& late);

// The command line has 0 for "never", the options infinity. Throws InputError below 0 and for NaN.
double InfiniteIfZero(const std::string& argument, double value);

}  // namespace fathom
