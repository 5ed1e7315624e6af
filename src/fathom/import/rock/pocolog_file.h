// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_container.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file with these first bytes is a log of Rock's pocolog.
bool LooksLikePocolog(std::string_view first_bytes);

// A log of Rock (pocolog, version 2): blocks that declare streams, each with its type, and blocks
// that hold samples. The time of a sample is its logical time, when Rock's task had it. A cut or
// damaged file is read up to the first block that is not sound. Throws InputError for another
// version, and for one of a machine with the most significant byte first.
// Source: lib/pocolog of https://github.com/rock-core/tools-pocolog.
std::unique_ptr<MessageContainer> OpenPocolog(const std::filesystem::path& path);

}  // namespace fathom
