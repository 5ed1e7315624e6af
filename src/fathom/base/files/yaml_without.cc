// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/yaml_without.h"

#include <yaml-cpp/yaml.h>

namespace fathom {

std::string YamlWithout(const std::string& text, const std::string& key) {
  YAML::Node file = YAML::Load(text);
  file.remove(key);
  YAML::Emitter yaml;
  yaml << file;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace fathom
