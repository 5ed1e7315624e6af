// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/image_comparison_file.h"

#include "fathom/comparison/comparison_file.h"

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json ValueWithStd(double value, double std) { return {{"value", value}, {"std", std}}; }

Json FormatSegment(const RefinedSegment& segment) {
  return {{"num_frames", segment.world_from_body.size()},
          {"num_outliers", segment.num_outliers},
          {"start_velocity", segment.start.velocity},
          {"start_position", segment.start.position},
          {"clock_offset", ValueWithStd(segment.clock_offset, segment.clock_offset_std)}};
}

Json FormatJoint(const ImageComparison& comparison) {
  const JointSummary& joint = comparison.joint;
  Json json = {{"usable", joint.IsUsable()},
               {"message", joint.message},
               {"num_detections", joint.num_detections},
               {"num_rounds", joint.num_rounds},
               {"num_iterations", joint.num_iterations},
               {"final_cost", joint.final_cost}};
  if (!joint.IsUsable()) return json;
  json["corner_sigma_px"] = joint.processes.corner_sigma;
  json["model_error"] = joint.processes.model_error;
  Json held = Json::array();
  for (const HeldDofFound& found : HeldDofsOf(comparison)) {
    held.push_back({{"dof", Name(found.dof)},
                    {"unit", DisplacementUnit(found.dof)},
                    {"wander_std", found.wander.std},
                    {"wander_frequency", found.wander.frequency},
                    {"wander_damping_ratio", found.wander.ratio},
                    {"response_std", found.response_std}});
  }
  json["held_dofs"] = held;
  json["size_scale"] = ValueWithStd(joint.size_scale, joint.size_scale_std);
  Json mount = Json::array();
  for (size_t i = 0; i < joint.mount.size(); ++i) {
    mount.push_back(ValueWithStd(joint.mount[i], joint.mount_std[i]));
  }
  json["mount"] = mount;
  Json runs = Json::array();
  for (const RefinedSegment& segment : joint.segments) runs.push_back(FormatSegment(segment));
  json["runs"] = runs;
  return json;
}

}  // namespace

std::string FormatImageComparison(const ImageComparison& comparison) {
  Json json = Json::parse(FormatComparison(comparison.comparison));
  json["remarks"] = comparison.comparison.remarks;
  for (const std::string& remark : comparison.comparison.dofs.front().remarks) {
    json["remarks"].push_back(remark);
  }
  json["moved_markers"] = Json::array();
  for (const auto& [log, marker] : comparison.moved_markers) {
    json["moved_markers"].push_back(
        {{"log", log},
         {"tag_id", marker.tag_id},
         {"t", marker.time},
         {"distance", ValueWithStd(marker.distance, marker.distance_std)},
         {"angle", marker.angle}});
  }
  json["joint"] = FormatJoint(comparison);
  return json.dump(2) + "\n";
}

}  // namespace fathom
