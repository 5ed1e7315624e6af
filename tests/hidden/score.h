// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/diagnosis.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "hidden_log.h"
#include "oracle.h"

namespace fathom::hidden {

// What a diagnosis made of a log.
enum class Outcome {
  kAlone,         // exactly what is hidden is named, with no alternatives
  kGroup,         // what is hidden is named or among the alternatives, one cause for each, no more
  kPart,          // of two: one is named, nothing wrong is, and the other is not
  kAbstained,     // no cause is named
  kGroupWithout,  // causes are named, each with alternatives, and what is hidden is missing
  kWrong,         // a cause is named with no alternatives and is not hidden
};
inline constexpr int kNumOutcomes = 6;
std::string_view Name(Outcome outcome);

// How many 95 % intervals hold the truth.
struct Coverage {
  int inside = 0;
  int total = 0;
  int missing = 0;  // no finite interval was given

  void Add(const Coverage& other);
};

struct LogScore {
  std::string name;   // of the plan
  std::string setup;  // as Truth has it
  HiddenClass hidden = HiddenClass::kNothing;
  std::vector<std::string> effects;  // names of what is hidden
  OracleAnswer oracle;

  Outcome outcome = Outcome::kAbstained;
  Verdict verdict = Verdict::kConsistent;
  std::string named;                 // "thruster_lag / time_offset; sensor_bias"
  std::vector<std::string> certain;  // names of causes without alternatives

  // 1 - NMAE / NMAE of the oracle's baseline on data held out, all by the oracle's yardstick; NaN
  // where nothing is held out.
  double gain = std::numeric_limits<double>::quiet_NaN();
  double oracle_gain = std::numeric_limits<double>::quiet_NaN();

  // Where exactly what is hidden is named, or where nothing is hidden and nothing named.
  Coverage effect_parameters, model_parameters;

  double seconds = std::numeric_limits<double>::quiet_NaN();  // that the diagnosis took

  bool HasCause() const { return !named.empty(); }
  bool HasCertainCause() const { return verdict == Verdict::kExplained && !certain.empty(); }
};

LogScore ScoreOf(const HiddenLog& hidden, const OracleAnswer& oracle, const Diagnosis& diagnosis);

}  // namespace fathom::hidden
