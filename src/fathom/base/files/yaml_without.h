// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// The text of a YAML file whose top level is a map, without one of the map's keys and without
// comments; the values stand as they did. The text has been read by ParseYaml().
std::string YamlWithout(const std::string& text, const std::string& key);

}  // namespace fathom
