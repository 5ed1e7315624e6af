// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Text from files as a comment of any target holds it: on one line, and without what would end the
// comment or begin another one.
std::string CommentText(std::string_view text);

// A number as C, XML and MATLAB read it back to the bit, with a point or an exponent: "40.0".
std::string LiteralOf(double value);

// 95 % of a number, NaN where that is not known. That of an inertia or a damping on the diagonal
// ends at 0.
struct Interval95 {
  double low = 0.0;
  double high = 0.0;
};
Interval95 IntervalOf(const ExportNumber& number);
Interval95 IntervalOf(const ExportEffectValue& value);

// "kg, 95 % interval 39.6 to 40.8, log tank_07".
std::string CommentOn(const ExportNumber& number);
std::string CommentOn(const ExportEffectValue& value, const std::string& log);

// What heads every file, a line each: the model, who made it, from what, and `remarks`.
std::vector<std::string> HeadLines(const ExportModel& model,
                                   const ExportTarget& target,
                                   const std::vector<std::string>& remarks);

}  // namespace fathom
