// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/pose_remarks.h"

#include "fathom/base/files/yaml_file.h"
#include "fathom/base/quoted.h"

#include <cstdint>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace fathom {
namespace {

constexpr const char* kPoses = "poses";
constexpr const char* kLostMotion = "lost_motion";

RemarkKind KindOf(const YamlMap& remark) {
  const std::string kind = remark.String("kind");
  if (kind == kPoses) return RemarkKind::kPoses;
  if (kind == kLostMotion) return RemarkKind::kLostMotion;
  remark.Fail("kind", fmt::format("is {}, expected {} or {}.", Quoted(kind), kPoses, kLostMotion));
}

// Files from before the kinds hold plain sentences; the one that matters is known by its words.
Remark FromPlainSentence(const std::string& text) {
  const bool is_on_lost_motion =
      text.find(" poses rest on a single marker whose tilt they know to ") != std::string::npos;
  return {is_on_lost_motion ? RemarkKind::kLostMotion : RemarkKind::kPoses, text};
}

std::vector<Remark> RemarksIn(const YamlMap& file) {
  std::vector<Remark> remarks;
  if (file.HoldsMaps("remarks")) {
    for (const YamlMap& remark : file.Maps("remarks")) {
      remarks.push_back({KindOf(remark), remark.String("text")});
    }
  } else {
    for (const std::string& text : file.Strings("remarks")) {
      remarks.push_back(FromPlainSentence(text));
    }
  }
  return remarks;
}

}  // namespace

std::vector<Remark> ParsePoseRemarks(const std::string& name,
                                     const std::string& text,
                                     std::size_t num_poses) {
  const YamlMap file = ParseYaml(name, text);
  const std::int64_t num_told_of = file.Integer("poses");
  std::vector<Remark> remarks = RemarksIn(file);
  file.Finish();
  if (num_told_of != static_cast<std::int64_t>(num_poses)) {
    file.Fail("poses",
              fmt::format("is {}, but pose.csv holds {}, expected remarks on those poses. Remove "
                          "this file if pose.csv was replaced.",
                          num_told_of,
                          num_poses));
  }
  return remarks;
}

std::string FormatPoseRemarks(std::span<const Remark> remarks, std::size_t num_poses) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "poses" << YAML::Value << num_poses;
  yaml << YAML::Key << "remarks" << YAML::Value << YAML::BeginSeq;
  for (const Remark& remark : remarks) {
    yaml << YAML::BeginMap;
    yaml << YAML::Key << "kind" << YAML::Value
         << (remark.kind == RemarkKind::kLostMotion ? kLostMotion : kPoses);
    yaml << YAML::Key << "text" << YAML::Value << YAML::DoubleQuoted << remark.text;
    yaml << YAML::EndMap;
  }
  yaml << YAML::EndSeq << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace fathom
