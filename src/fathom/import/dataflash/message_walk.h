// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/dataflash/message_format.h"
#include "fathom/import/recording/byte_file.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace fathom {

// By the type that stands in a message's header.
using MessageFormats = std::array<MessageFormat, 256>;

// What lies between the messages of a DataFlash log.
struct MessageWalk {
  std::uint64_t skipped_bytes = 0;  // of no message
  std::uint64_t first_skipped = 0;  // where they begin
  std::uint64_t padding_bytes = 0;  // zeros at the end of the file: a card's last block
  std::uint64_t cut_bytes = 0;      // of a message that the file ends in
  std::string cut_message;          // its name
};

// Calls `take` with every whole message of a known type, in the order of the file; they last for
// the call. A message counts where the one before it ends. After bytes that begin none, it counts
// where another follows it: 0xA3 0x95 occurs in payloads too.
MessageWalk ForEachMessage(
    ByteFile* file,
    const MessageFormats& formats,
    const std::function<void(const MessageFormat& format, std::string_view message)>& take);

// All formats that the file defines, wherever in it, without units. Of two that define one type
// differently the first holds; `num_redefined` counts the others.
MessageFormats ReadFormats(ByteFile* file, int* num_redefined);

}  // namespace fathom
