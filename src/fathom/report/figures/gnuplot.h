// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom {

// Text as a gnuplot string, in single quotes.
std::string GnuplotText(std::string_view text);

// Lets gnuplot run the script and writes what it draws to `path`, as SVG or PNG by the extension.
// `width` and `height` are in pixels of the SVG; a PNG has twice as many. Throws InputError for
// another extension, if gnuplot is not installed, if it fails, or if the file cannot be written.
void DrawWithGnuplot(const std::string& script,
                     int width,
                     int height,
                     const std::filesystem::path& path);

}  // namespace fathom
