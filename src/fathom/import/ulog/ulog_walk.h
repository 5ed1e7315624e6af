// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/byte_file.h"

#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace fathom {

// What stands at the beginning of a ULog file.
struct UlogHead {
  int version = 0;
  // From ... to [bytes] of the file, in its order: the log, then what was appended to it, as after
  // a crash. The log may end within a message.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> sections;
  bool has_bad_offsets = false;  // appended data beyond the file, or in no order: not looked for
};

// Throws InputError, naming the file, if its header is not whole or its flags (message 'B') say
// that it is of a kind that readers of today cannot read.
UlogHead ReadUlogHead(ByteFile* file);

// What lies between the messages of a ULog file.
struct UlogWalk {
  std::uint64_t skipped_bytes = 0;  // of no message
  std::uint64_t first_skipped = 0;  // where they begin
  std::uint64_t cut_bytes = 0;      // of messages that the file, or the log in it, ends in
  std::uint64_t first_cut = 0;      // where the first of them begins
};

// Calls `take` with the type and the payload of every whole message, in the order of the file; they
// last for the call. A message counts where the one before it ends. After damage the walk goes on
// at the next sync message ('S'), or where three messages follow each other: the three bytes that
// begin one occur within messages too.
UlogWalk ForEachUlogMessage(ByteFile* file,
                            const UlogHead& head,
                            const std::function<void(char type, std::string_view payload)>& take);

}  // namespace fathom
