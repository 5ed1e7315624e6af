// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_follower.h"
#include "fathom/adaptive/adaptive_identifier.h"
#include "fathom/base/dof.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom {

// The state file of a stream that is followed (JSON, fathom-follow-1), docs/file_formats.md. It
// holds the dof and the options too, so that nobody goes on with others. The follower must be
// finite.
std::string FormatFollower(Dof dof,
                           const AdaptiveOptions& options,
                           const AdaptiveFollower& follower);

// The follower that goes on as the one that was written would have, to the last digit. `name`
// stands for the file in messages. Throws InputError, naming file and key, for what is no such
// file and for one of another dof or of other options.
AdaptiveFollower ParseFollower(const std::string& name,
                               std::string_view text,
                               Dof dof,
                               const AdaptiveOptions& options);

// The same of a file.
AdaptiveFollower ReadFollower(const std::filesystem::path& path,
                              Dof dof,
                              const AdaptiveOptions& options);

}  // namespace fathom
