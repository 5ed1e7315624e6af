// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/report/panel.h"

#include <string>
#include <vector>

namespace fathom {

// An empty panel for one curve of values that hold until the next stamp: a command.
TimePanel HeldCurvePanel(const std::string& quantity, const std::string& unit);

// Adds what held from one time to another, and a gap behind it. Values hold from their stamps on,
// the last one for ever; before the first stamp there was 0. `shift` leads from the stamps to the
// time of the panel [s].
void AppendHeldCurve(const std::vector<double>& stamps,
                     const std::vector<double>& values,
                     const TimeInterval& shown,
                     double shift,
                     TimePanel* panel);

}  // namespace fathom
