// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is an .alog of MOOS: its head lines tell.
bool LooksLikeAlog(std::string_view first_bytes);

// A log of MOOS-IvP's pLogger (.alog): lines of "time variable source value", docs/import_moos.md.
// A channel is a variable that is a number in some lines, its field is "value". Stamps are seconds
// since LOGSTART, which the head states in UTC. Texts are counted, so are lines that stand twice
// and those that are no such lines. A file is read up to a NUL byte or a line of over 1 MiB, and
// never a last line without its end. Throws InputError for a file without a number.
// Source: pLogger (CMOOSLogger) and ivp/src/lib_logutils of https://github.com/moos-ivp/moos-ivp.
std::unique_ptr<Recording> OpenAlog(const std::filesystem::path& path);

}  // namespace fathom
