// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// One curve over the time stamps of its panel. NaN is a gap: the line stops there and goes on
// behind it.
struct Series {
  std::string name;
  std::vector<double> values;
  std::string note = {};  // shown beside the name: "MAE 0.012 m/s"

  // Of a band to either side of the curve, shaded; one for each value, or empty: no band.
  std::vector<double> half_width = {};

  bool is_faded = false;  // of a page: thin and pale until a reader asks for it

  // Curves of one meaning share the color of this name; empty: each by its own name.
  std::string color_name = {};

  const std::string& ColorName() const { return color_name.empty() ? name : color_name; }
};

// Curves over time: what was measured, what was computed for it, and below it measured minus
// computed. The curves keep their colour by name through a whole page.
struct TimePanel {
  std::string title;         // may be empty
  std::string quantity;      // "surge velocity"
  std::string unit;          // "m/s"; may be empty
  std::vector<double> time;  // [s], not decreasing; every series has a value for each stamp

  std::optional<Series> measured = {};
  std::vector<Series> responses = {};

  std::vector<TimeInterval> held_out = {};  // shaded and labelled
  bool is_stepped = false;                  // values hold until the next stamp, as commands do
  bool has_residuals = true;                // without `measured` there are none
  bool is_low = false;                      // drawn less tall, for a first screen
};

// A number as one way of estimating it gave it. NaN in `value` is no answer, NaN in `std` an answer
// without an interval.
struct Estimate {
  std::string name;
  double value = std::numeric_limits<double>::quiet_NaN();
  double std = std::numeric_limits<double>::quiet_NaN();
};

// Several estimates of one number, as dots with 95 % intervals (1.96 std).
struct ParameterPanel {
  std::string name;  // "inertia"
  std::string unit;  // "kg"; may be empty
  std::vector<Estimate> estimates = {};
  std::optional<double> reference = {};  // a line across: the truth, a value from a data sheet
  std::string reference_name = "truth";

  // What the parameter can be: bars end there, open. An estimate beyond a bound keeps its whole
  // bar.
  double lower_bound = -std::numeric_limits<double>::infinity();
  double upper_bound = std::numeric_limits<double>::infinity();
};

// Points of one quantity over another, with the course of their means and of another quantity's
// means over the same bins.
struct ScatterPanel {
  std::string x_name;  // "command"
  std::string x_unit;  // "N"; may be empty
  std::string y_name;
  std::string y_unit;
  std::vector<double> x;
  std::vector<double> y;         // one for each x; points with a NaN in either are left out
  std::vector<double> second_y;  // as many, or empty: nothing to compare with
  std::string second_name;       // "explained"
  std::string note;              // beside the name of x; may be empty
};

// A curve over anything, with a band that does not depend on it and a stretch of x marked.
struct CurvePanel {
  std::string x_name;  // "frequency"
  std::string x_unit;  // "Hz"; may be empty
  std::string y_name;
  std::string y_unit = {};
  std::vector<double> x;  // in its order; of a logarithmic axis above 0
  std::vector<double> y;  // one for each x

  // From `low` to `high`, one for each x; or both empty: no band.
  std::vector<double> low = {};
  std::vector<double> high = {};
  std::string band_name = {};  // "white noise, 95 %"

  std::optional<TimeInterval> marked = {};
  std::string marked_name = {};

  bool is_log_x = false;
  bool is_log_y = false;
  std::string note = {};  // beside the name of y
};

// A path over the ground.
struct PlanCurve {
  std::string name;
  std::vector<double> ahead;      // along the first course [m]
  std::vector<double> starboard;  // across it [m], one for each
};

// A limit as a straight line, across the way ahead or along it.
struct PlanLimit {
  std::string name;
  bool is_along = false;  // at so much to starboard; else at so much ahead
  double at = 0.0;        // [m]
};

// Paths seen from above, ahead to the right and starboard down, a metre as long in both directions.
struct PlanPanel {
  std::string title;
  PlanCurve curve;
  std::optional<PlanCurve> measured = {};
  std::vector<PlanCurve> others = {};  // pale, behind the rest: their names are not shown
  std::string others_name = {};        // "95 % of the drawn models"
  std::vector<PlanLimit> limits = {};
};

}  // namespace fathom
