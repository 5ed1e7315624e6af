// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A field of a DataFlash message. `letter` is its type in the FMT message, as 'f' or 'c'; of an
// array ('a', 32 numbers of 16 bits) each element is a field: "D[0]", "D[1]", ...
struct MessageField {
  std::string name;
  char letter = 0;
  std::size_t offset = 0;                // from the first byte of the message, which is 0xA3
  std::string unit;                      // as UNIT and FMTU state it; may be empty
  NumberType type = NumberType::kUint8;  // of a number
  double divisor = 1.0;
  double multiplier = 1.0;  // of an integer, as MULT and FMTU state it
};

// What an FMT message says of the messages of one type; docs/import.md.
struct MessageFormat {
  int type = -1;           // -1: no such type
  std::size_t length = 0;  // of the whole message [bytes], with its header of three
  std::string name;
  std::vector<MessageField> numbers;  // those that lie within `length`
  std::vector<MessageField> texts;    // likewise
  std::vector<std::string> columns;   // the names of all fields as FMT lists them

  // Null if there is none.
  const MessageField* FindNumber(std::string_view field) const;
  const MessageField* FindText(std::string_view field) const;
};

inline constexpr int kFmtType = 128;

// FMT itself, which a reader has to know before it reads any.
MessageFormat FormatOfFmt();

// From a whole FMT message. `type` is -1 where it cannot be one: no length, no name.
MessageFormat ParseFmt(std::string_view message);

// The field of a whole message in its unit, scaled as its letter and its multiplier say.
double ValueOf(const MessageField& number, std::string_view message);

// The field of a whole message up to its first NUL.
std::string_view TextOf(const MessageField& text, std::string_view message);

// Whether a multiplier applies: a letter as 'c' scales by itself, and floats are in their unit
// whatever MULT says (ArduSub's CTUN.BAlt).
bool TakesMultiplier(char letter);

}  // namespace fathom
