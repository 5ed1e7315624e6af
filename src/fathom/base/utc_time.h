// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fathom {

// Seconds since 1970-01-01T00:00:00Z of an instant in the form of ISO 8601: "2026-05-03",
// "2026-05-03T14:30Z", "2026-05-03T14:30:05.25Z", also with a space for the T and without the Z.
// Always UTC. Nothing for anything else, also for days that no calendar has.
std::optional<double> ParseUtc(std::string_view text);

// "2026-05-03T14:30:05Z", with the fraction of a second where there is one. Years 1 to 9999; empty
// for any other time.
std::string FormatUtc(double seconds);

}  // namespace fathom
