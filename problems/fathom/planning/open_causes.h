// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/rival_model.h"
#include "fathom/vehicle/files/json_value.h"
#include "fathom/vehicle/fitted_model.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The explanations that a verdict leaves open.
struct OpenCauses {
  // The verdict's own model, and one for each alternative that an experiment along this DOF can
  // tell from it; none where there is no alternative.
  std::vector<RivalModel> rivals;
  // Mean size of the velocity's noise, [m/s] or [rad/s]; NaN where the file does not tell. It is
  // what scatters from sample to sample: the free run of a cause that is wrong misses by more.
  // Where the leading cause misses over three times that, something else is missing too, and it is
  // all of that.
  double noise = std::numeric_limits<double>::quiet_NaN();

  std::vector<std::string> left_out;  // the other alternatives, with the reason: a sentence each
};

// The `causes` of a verdict file that is `ambiguous`, each with its `alternatives`; none of a
// verdict that is not, and of a model file.
std::vector<JsonValue> AmbiguousCauses(const JsonValue& file);

// From the text of a verdict file ("fathom-verdict-1") and the model in it; `name` stands for the
// file in messages. None of a verdict that is not `ambiguous`, and of a model file. An alternative
// has the baseline of the verdict's model and its own numbers as fitted alone.
OpenCauses ReadOpenCauses(const std::string& name,
                          std::string_view text,
                          const FittedModel& fitted);

}  // namespace fathom
