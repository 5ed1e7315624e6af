// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/time_interval.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What is known of a log before its log.yaml is written.
struct KnownOfLog {
  std::string name;
  std::vector<Dof> dofs;                  // that it may excite, at least one
  std::string vehicle = {};               // the vehicle file beside it; may be empty
  std::string video = {};                 // may be empty
  std::optional<TimeInterval> span = {};  // of its motion
};

// A log.yaml that can be read as it is. Every further key stands as a comment, "#key: value", below
// a line that says what it does; docs/file_formats.md.
std::string StarterLogYaml(const KnownOfLog& known);

// A vehicle file that can be read as it is; mass, size, thrusters and their table stand as
// comments. `num_thrusters`: 2 where it is not known.
std::string StarterVehicleYaml(const std::string& name, std::size_t num_thrusters);

// A map with the text `suggested` of a SuggestedMap; docs/import.md. It can be read as it is where
// that names a stream. `span`: of the recording's stamps, where it has any.
std::string StarterMapYaml(const std::string& name,
                           const std::optional<TimeInterval>& span,
                           const std::string& suggested);

}  // namespace fathom
