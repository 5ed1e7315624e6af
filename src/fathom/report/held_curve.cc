// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/held_curve.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <glog/logging.h>

namespace fathom {

TimePanel HeldCurvePanel(const std::string& quantity, const std::string& unit) {
  TimePanel panel;
  panel.quantity = quantity;
  panel.unit = unit;
  panel.is_stepped = true;
  panel.is_low = true;
  panel.responses.push_back({"commanded", {}});
  return panel;
}

void AppendHeldCurve(const std::vector<double>& stamps,
                     const std::vector<double>& values,
                     const TimeInterval& shown,
                     double shift,
                     TimePanel* panel) {
  CHECK_EQ(stamps.size(), values.size());
  const auto add = [&](double time, double value) {
    panel->time.push_back(time + shift);
    panel->responses.front().values.push_back(value);
  };
  const auto next = std::upper_bound(stamps.begin(), stamps.end(), shown.from);
  auto i = static_cast<std::size_t>(next - stamps.begin());
  double held = i == 0 ? 0.0 : values[i - 1];
  add(shown.from, held);
  for (; i < stamps.size() && stamps[i] < shown.to; ++i) {
    held = values[i];
    add(stamps[i], held);
  }
  add(shown.to, held);
  add(shown.to, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace fathom
