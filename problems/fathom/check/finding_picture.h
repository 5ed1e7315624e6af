// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"
#include "fathom/findings/finding.h"
#include "fathom/report/page.h"

#include <optional>

namespace fathom {

// A finding as a section of its own: the signal that it is about, half as long again on either side
// of its place (5 s at least), with the place in colour, and the command of the DOF below. Of
// `command_delay` and `camera_delay` the correlation over the delay. Nothing of a finding without a
// place.
//
// `dof`: whose finding it is; null: of the log.
std::optional<PageSection> PictureOf(const Finding& finding, const Log& log, const DofCheckup* dof);

}  // namespace fathom
