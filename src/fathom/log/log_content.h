// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Tells one log's files from another's: 32 hexadecimal digits over every byte of InputFilesOf() it
// (XXH3, 128 bits), and over their names within the log; not over the name of its folder. Unlike
// FingerprintOf(), which is of the data alone, it changes with whatever may change a result: the
// calibration, the vehicle, the held-out intervals. Not for security.
//
// Reads in pieces, in bounded memory. Throws InputError, naming the file, for what cannot be read
// or is no file, as a pipe or a device.
std::string ContentOf(const std::filesystem::path& log);

// The same digits of a text, and of several texts one after the other ("a", "bc" is not "ab", "c").
std::string DigestOf(std::string_view text);
std::string DigestOf(const std::vector<std::string>& texts);

}  // namespace fathom
