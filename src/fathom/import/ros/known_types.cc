// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ros/known_types.h"

#include "fathom/import/recording/data_files.h"

#include <cstddef>

#include <fmt/format.h>

namespace fathom {

using data_files::ros_types;

std::string KnownDefinition(std::string_view type) {
  const std::string head = fmt::format("MSG: {}\n", WithoutMsg(type));
  const std::size_t begin = ros_types.find(head);
  if (begin == std::string_view::npos) return {};
  const std::string_view text = ros_types.substr(begin + head.size());
  return std::string(text.substr(0, text.find("===\n"))) + std::string(ros_types);
}

std::string WithoutMsg(std::string_view type) {
  std::string name(type);
  const std::size_t middle = name.find("/msg/");
  if (middle != std::string::npos) name.erase(middle, 4);
  return name;
}

}  // namespace fathom
