// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/image_comparison_page.h"

#include "fathom/comparison/comparison_page.h"
#include "fathom/identification/identification_text.h"
#include "fathom/report/format_value.h"
#include "fathom/signal/pose_velocity.h"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Poses PosesIn(const std::vector<double>& time, const std::vector<Pose>& world_from_body) {
  Poses poses;
  poses.time = time;
  for (const Pose& pose : world_from_body) {
    Eigen::Quaterniond q = pose.rotation;
    // Neighbours in one hemisphere, as Poses promises.
    if (!poses.world_from_body.empty() && q.dot(poses.world_from_body.back()) < 0.0) {
      q.coeffs() *= -1.0;
    }
    poses.position.push_back(pose.translation);
    poses.world_from_body.push_back(q);
  }
  return poses;
}

// Displacement of the excited DOF over the runs that were refined, a gap between runs.
TimePanel PathPanel(const MarkerLogs& logs, const ImageComparison& comparison) {
  TimePanel panel;
  panel.quantity = fmt::format("{} displacement", Name(logs.dof));
  panel.unit = DisplacementUnit(logs.dof);
  panel.measured = Series{"PnP", {}, ""};
  panel.responses.push_back({"refined", {}, ""});
  const auto append = [](const std::vector<double>& values, Series* series) {
    series->values.insert(series->values.end(), values.begin(), values.end());
    series->values.push_back(kNaN);
  };
  if (logs.logs.size() > 1) {
    panel.title = fmt::format("{} logs, one behind the other", logs.logs.size());
  }
  double origin = 0.0, shift = 0.0;
  for (size_t r = 0; r < comparison.joint.segments.size(); ++r) {
    const CameraSegment& before = logs.input.segments[r];
    const RefinedSegment& after = comparison.joint.segments[r];
    // Logs one behind the other: their clocks may start anew.
    const bool is_new_log = r == 0 || logs.log_of_segment[r] != logs.log_of_segment[r - 1];
    if (is_new_log) {
      origin = before.time.front();
      shift = panel.time.empty() ? 0.0 : panel.time.back() + 1.0;
    }
    for (const double t : before.time) panel.time.push_back(t - origin + shift);
    panel.time.push_back(panel.time.back());
    append(DisplacementAlong(logs.dof, PosesIn(before.time, before.world_from_body)),
           &*panel.measured);
    append(DisplacementAlong(logs.dof, PosesIn(before.time, after.world_from_body)),
           &panel.responses[0]);
  }
  return panel;
}

}  // namespace

Table IntervalTable(const ImageComparison& comparison) {
  Table table;
  table.caption = "95 % intervals";
  table.columns = {{"model"}, {"parameter"}, {"value", true}, {"unit"}, {"95 % interval", true}};
  for (const Identification& row : comparison.comparison.dofs.front().rows) {
    if (!row.is_usable) {
      table.rows.push_back({{ModelName(row), "-", "-", "", "-"}, RowFlag::kUnusable});
      continue;
    }
    const ParameterVector values = ToVector(row.fitted.model);
    for (int i = 0; i < kNumParameters; ++i) {
      const double std = std::sqrt(row.fitted.covariance(i, i));
      table.rows.push_back({{ModelName(row),
                             kParameterInfo[i].name,
                             FormatValue(values[i], std),
                             UnitText(ParameterUnit(i, row.fitted.dof, row.fitted.force_unit)),
                             FormatInterval(values[i], std, kParameterInfo[i].lower_bound)}});
    }
  }
  return table;
}

Table RefinementTable(const ImageComparison& comparison) {
  const JointSummary& joint = comparison.joint;
  Table table;
  table.caption = "Further results from the corners";
  table.columns = {{"quantity"}, {"value", true}, {"unit"}};
  const auto add = [&](std::string name, std::string value, std::string_view unit) {
    table.rows.push_back({{std::move(name), std::move(value), std::string(unit)}});
  };
  int num_outliers = 0;
  for (const RefinedSegment& segment : joint.segments) num_outliers += segment.num_outliers;
  add("detections", fmt::format("{}", joint.num_detections), "");
  add("of these, outliers", fmt::format("{}", num_outliers), "");
  add("corner sigma", fmt::format("{:.3g}", joint.processes.corner_sigma), "px");
  for (const auto& [log, marker] : comparison.moved_markers) {
    add(fmt::format("tag {} moved at t = {:.1f} s, by", marker.tag_id, marker.time),
        FormatValue(marker.distance, marker.distance_std),
        "m");
  }
  for (const HeldDofFound& found : HeldDofsOf(comparison)) {
    add(fmt::format("wander of {}", Name(found.dof)),
        found.wander.IsPresent() ? fmt::format("{:.2g}", found.wander.std) : "0",
        DisplacementUnit(found.dof));
    if (found.response_std > 0.0) {
      add(fmt::format("response of {} to the motion", Name(found.dof)),
          fmt::format("{:.2g}", found.response_std),
          DisplacementUnit(found.dof));
    }
  }
  constexpr double kDrift = 10.0;  // [s]
  const auto strays = [&] { return std::sqrt(joint.processes.ModelError().Over(kDrift).Q(0, 0)); };
  const Dof dof = comparison.comparison.dofs[0].dof;
  add(fmt::format("drift of {} from the model in {:.0f} s", Name(dof), kDrift),
      joint.processes.model_error > 0.0 ? fmt::format("{:.2g}", strays()) : "0",
      DisplacementUnit(dof));
  for (size_t r = 0; r < joint.segments.size(); ++r) {
    const RefinedSegment& segment = joint.segments[r];
    if (segment.clock_offset_std == 0.0) continue;
    add(fmt::format("clock offset of segment {}", r + 1),
        FormatValue(segment.clock_offset, segment.clock_offset_std),
        "s");
  }
  if (joint.size_scale_std > 0.0) {
    add("size scale", FormatValue(joint.size_scale, joint.size_scale_std), "");
  }
  constexpr std::array<const char*, 6> kMount = {"x", "y", "z", "about x", "about y", "about z"};
  for (size_t i = 0; i < kMount.size(); ++i) {
    if (joint.mount_std[i] == 0.0) continue;
    add(fmt::format("mount, {}", kMount[i]),
        FormatValue(joint.mount[i], joint.mount_std[i]),
        i < 3 ? "m" : "rad");
  }
  return table;
}

Page ImageComparisonPage(const MarkerLogs& logs, const ImageComparison& comparison) {
  Page page = ComparisonPage(comparison.comparison);
  page.title = fmt::format("{}: models from images", comparison.comparison.log_name);
  page.subtitle =
      "Every identifier family on the same corners, scored by simulating from the "
      "command alone";
  if (!comparison.joint.IsUsable()) {
    page.warnings.push_back("The joint refinement found no usable model: " +
                            comparison.joint.message);
    return page;
  }
  PageSection section;
  section.heading = "Trajectory and corners";
  section.text.push_back(
      "The joint refinement estimates model, trajectory and corner errors together "
      "(docs/joint_refinement.md). PnP solves each frame separately.");
  section.time_panels.push_back(PathPanel(logs, comparison));
  section.tables = {IntervalTable(comparison), RefinementTable(comparison)};
  page.sections.push_back(std::move(section));
  return page;
}

}  // namespace fathom
