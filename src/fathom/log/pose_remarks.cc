// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/pose_remarks.h"

#include "fathom/base/files/yaml_file.h"

#include <cstdint>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace fathom {

std::vector<std::string> ParsePoseRemarks(const std::string& name,
                                          const std::string& text,
                                          std::size_t num_poses) {
  const YamlMap file = ParseYaml(name, text);
  const std::int64_t num_told_of = file.Integer("poses");
  std::vector<std::string> remarks = file.Strings("remarks");
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

std::string FormatPoseRemarks(std::span<const std::string> remarks, std::size_t num_poses) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "poses" << YAML::Value << num_poses;
  yaml << YAML::Key << "remarks" << YAML::Value << YAML::BeginSeq;
  for (const std::string& remark : remarks) yaml << YAML::DoubleQuoted << remark;
  yaml << YAML::EndSeq << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace fathom
