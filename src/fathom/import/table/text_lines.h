// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/byte_file.h"

#include <cstdint>
#include <string_view>

namespace fathom {

// The lines of a text file one by one, in bounded memory. A byte order mark of UTF-8 is stepped
// over; a line ends in LF or CR LF.
class TextLines {
 public:
  // `offset`: where a line begins; `line_number`: its number, from 1.
  explicit TextLines(ByteFile* file, std::uint64_t offset = 0, std::int64_t line_number = 1);

  // Takes a line break within quotes for a part of a cell (RFC 4180), so that a line may be several
  // of the file. A quote opens where a cell begins; one that no line close by closes is a character
  // as others.
  void JoinQuoted() { joins_quoted_ = true; }

  // Goes to the next line; false at the end of the file. Throws InputError, naming file and line,
  // for a line of over 1 MiB and a NUL byte: that is no text.
  bool Next();

  std::string_view text() const { return text_; }      // until the next call, without its end
  std::int64_t number() const { return number_; }      // from 1; of several the first
  std::uint64_t offset() const { return offset_; }     // where it begins
  std::uint64_t next_offset() const { return next_; }  // where the next one begins
  bool has_end() const { return has_end_; }            // false: the file ends without one

 private:
  void TakeQuotedLines();

  ByteFile* file_;
  std::string_view text_;
  std::int64_t number_;
  std::uint64_t offset_;
  std::uint64_t next_;
  std::int64_t next_number_;
  bool has_end_ = true;
  bool joins_quoted_ = false;
};

}  // namespace fathom
