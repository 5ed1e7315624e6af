// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/finding_picture.h"

#include "fathom/findings/camera_delay.h"
#include "fathom/findings/command_clock.h"
#include "fathom/findings/twin_motion.h"
#include "fathom/findings/values/pose_yaw.h"
#include "fathom/open_log/open_log.h"
#include "fathom/report/held_curve.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kMark = "the finding";

struct Curve {
  std::string name, unit;
  std::vector<double> time, values;
};

std::string UnitOfAxis(const std::string& axis) {
  for (const Dof dof : kAllDofs) {
    if (axis == VelocityColumn(dof)) return std::string(VelocityUnit(dof));
  }
  if (axis == "yaw") return "rad";
  return axis.starts_with('q') ? "" : "m";
}

// The column that a place names.
std::optional<Curve> CurveAt(const FindingPlace& where, const Log& log) {
  for (const auto* stream : {&log.velocity, &log.pose}) {
    if (!*stream) continue;
    Curve curve = {where.axis, UnitOfAxis(where.axis), (*stream)->time, {}};
    if (const auto* values = (*stream)->Find(where.axis)) {
      curve.values = *values;
      return curve;
    }
    if (where.axis != "yaw") continue;
    if (auto yaw = UnwrappedYawOf(**stream)) {
      curve.values = *std::move(yaw);
      return curve;
    }
  }
  return std::nullopt;
}

// The motion of a DOF, with a gap behind each segment.
Curve MotionOf(const DofCheckup& dof) {
  Curve curve = {
      fmt::format("{} velocity", Name(dof.dof)), std::string(VelocityUnit(dof.dof)), {}, {}};
  for (const Segment& segment : dof.signals->train) {
    curve.time.insert(curve.time.end(), segment.time.begin(), segment.time.end());
    curve.values.insert(curve.values.end(), segment.velocity.begin(), segment.velocity.end());
    curve.time.push_back(segment.time.back());
    curve.values.push_back(kNan);
  }
  return curve;
}

TimeInterval ShownAbout(const TimeInterval& place) {
  constexpr double kLeast = 5.0, kShare = 0.5;  // [s], of the place
  const double margin = std::max(kLeast, kShare * (place.to - place.from));
  return {place.from - margin, place.to + margin};
}

// The values in the place, with a row on either side where `has_neighbours`: of one row alone no
// line can be drawn.
Series MarkOf(const std::vector<double>& time,
              const std::vector<double>& values,
              const TimeInterval& place,
              bool has_neighbours) {
  const auto row_of = [&](auto found) { return static_cast<std::size_t>(found - time.begin()); };
  std::size_t first = row_of(std::lower_bound(time.begin(), time.end(), place.from));
  std::size_t end = row_of(std::upper_bound(time.begin(), time.end(), place.to));
  if (has_neighbours) {
    first -= first > 0 ? 1 : 0;
    end += end < time.size() ? 1 : 0;
  }
  Series mark = {kMark, std::vector<double>(values.size(), kNan)};
  for (std::size_t i = first; i < end; ++i) mark.values[i] = values[i];
  return mark;
}

TimePanel MotionPanel(const Curve& curve, const TimeInterval& shown) {
  TimePanel panel;
  panel.quantity = curve.name;
  panel.unit = curve.unit;
  panel.has_residuals = false;
  panel.is_low = true;
  panel.measured = Series{"measured", {}};
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    if (curve.time[i] < shown.from || curve.time[i] > shown.to) continue;
    panel.time.push_back(curve.time[i]);
    panel.measured->values.push_back(curve.values[i]);
  }
  return panel;
}

TimePanel CommandPanel(const DofCheckup& dof, const TimeInterval& shown) {
  TimePanel panel =
      HeldCurvePanel(fmt::format("{} command", Name(dof.dof)), dof.signals->force_unit);
  AppendHeldCurve(dof.command.time, dof.command.value, shown, 0.0, &panel);
  return panel;
}

void AddTimePanels(const FindingPlace& where,
                   const Log& log,
                   const DofCheckup* dof,
                   PageSection* section) {
  const TimeInterval shown = ShownAbout(where.time);
  const bool has_command = dof != nullptr && dof->signals && !dof->command.time.empty();
  const bool is_of_command = where.axis.empty();
  std::optional<Curve> curve;
  if (!is_of_command) {
    curve = CurveAt(where, log);
  } else if (has_command) {
    curve = MotionOf(*dof);
  }
  if (curve) {
    TimePanel panel = MotionPanel(*curve, shown);
    if (!is_of_command) {
      panel.responses.push_back(MarkOf(panel.time, panel.measured->values, where.time, true));
    }
    section->time_panels.push_back(std::move(panel));
  }
  if (!has_command) return;
  TimePanel panel = CommandPanel(*dof, shown);
  if (is_of_command) {
    panel.responses.push_back(
        MarkOf(panel.time, panel.responses.front().values, where.time, false));
  }
  section->time_panels.push_back(std::move(panel));
}

// One motion as the log holds it twice; nothing if the log has no such column.
void AddTwinPanel(const std::string& column, const Log& log, PageSection* section) {
  for (const TwinMotion& motion : TwinMotionsOf(log)) {
    if (motion.column != column) continue;
    TimePanel panel;
    panel.quantity = column;
    panel.unit = VelocityUnit(motion.dof);
    panel.has_residuals = false;
    panel.time = motion.pose_time;
    panel.measured = Series{"velocity.csv", AtPoses(motion)};
    panel.responses.push_back({"from pose.csv, along the vehicle", motion.from_pose});
    if (!motion.in_world.empty()) {
      panel.responses.push_back({"from pose.csv, along the world", motion.in_world});
      panel.responses.back().is_faded = true;
    }
    section->time_panels.push_back(std::move(panel));
  }
}

// A correlation over the delay, with its peak marked; nothing of an empty curve.
void AddDelayCurve(const std::string& whose,
                   const std::string& with,
                   DelayCurve curve,
                   PageSection* section) {
  if (curve.delay.empty()) return;
  const auto best = std::ranges::max_element(curve.correlation);
  const double delay =
      curve.delay[static_cast<std::size_t>(std::distance(curve.correlation.begin(), best))];
  CurvePanel panel;
  panel.x_name = "delay of the " + whose;
  panel.x_unit = "s";
  panel.y_name = "correlation with " + with;
  panel.x = std::move(curve.delay);
  panel.y = std::move(curve.correlation);
  panel.marked = {delay, delay};
  panel.marked_name = fmt::format("the most, at {:.2f} s", delay);
  section->curve_panels.push_back(std::move(panel));
}

// Of the poses that the log holds, or else those of its markers.
void AddCameraDelay(Log log, PageSection* section) {
  if (!log.pose) TrackDetectionsIfUsable(&log);
  for (auto& [column, curve] : CameraDelayCurves(log)) {
    AddDelayCurve("camera", column + " of velocity.csv", std::move(curve), section);
  }
}

}  // namespace

std::optional<PageSection> PictureOf(const Finding& finding,
                                     const Log& log,
                                     const DofCheckup* dof) {
  PageSection section;
  if (finding.code.starts_with("pose_twist_") || finding.code == "lever_arm" ||
      finding.code == "mounting_angle") {
    AddTwinPanel(finding.where->axis, log, &section);
  } else if (finding.where) {
    AddTimePanels(*finding.where, log, dof, &section);
  } else if (finding.code == "command_delay" && dof != nullptr && dof->signals) {
    AddDelayCurve(
        "motion", "the command", CommandDelayCurve(dof->command, dof->signals->train), &section);
  } else if (finding.code == "camera_delay") {
    AddCameraDelay(log, &section);
  }
  if (section.time_panels.empty() && section.curve_panels.empty()) return std::nullopt;
  std::string what = finding.code;
  std::ranges::replace(what, '_', ' ');
  section.heading =
      fmt::format("{}: {}", dof == nullptr ? std::string_view("log") : Name(dof->dof), what);
  return section;
}

}  // namespace fathom
