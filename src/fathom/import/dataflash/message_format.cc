// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/dataflash/message_format.h"

#include "fathom/import/recording/number_type.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kHeader = 3;  // 0xA3 0x95 type
constexpr std::size_t kFmtLength = 89;
constexpr std::size_t kArray = 32;  // numbers of an 'a'

// The numbers that have a letter: how they are stored, and what divides them.
struct Letter {
  char letter;
  NumberType type;
  double divisor = 1.0;
};

constexpr Letter kLetters[] = {
    {'b', NumberType::kInt8},
    {'B', NumberType::kUint8},
    {'M', NumberType::kUint8},
    {'h', NumberType::kInt16},
    {'H', NumberType::kUint16},
    {'c', NumberType::kInt16, 100.0},
    {'C', NumberType::kUint16, 100.0},
    {'g', NumberType::kUint16},  // a half
    {'i', NumberType::kInt32},
    {'I', NumberType::kUint32},
    {'e', NumberType::kInt32, 100.0},
    {'E', NumberType::kUint32, 100.0},
    {'L', NumberType::kInt32, 1e7},
    {'f', NumberType::kFloat32},
    {'d', NumberType::kFloat64},
    {'q', NumberType::kInt64},
    {'Q', NumberType::kUint64},
};

// Null for a text or an array, and for a letter that nobody knows.
const Letter* FindLetter(char letter) {
  const auto* found = std::ranges::find(kLetters, letter, &Letter::letter);
  return found == std::end(kLetters) ? nullptr : found;
}

// Bytes of a field; 0 for a letter that nobody knows.
std::size_t SizeOf(char letter) {
  if (const Letter* number = FindLetter(letter)) return SizeOf(number->type);
  if (letter == 'n') return 4;
  if (letter == 'N') return 16;
  return letter == 'Z' || letter == 'a' ? 64 : 0;
}

bool IsText(char letter) { return letter == 'n' || letter == 'N' || letter == 'Z'; }

std::string_view UpToNul(std::string_view text) { return text.substr(0, text.find('\0')); }

// IEEE 754 binary16.
double Half(std::uint16_t bits) {
  const int exponent = (bits >> 10) & 0x1f;
  const double fraction = (bits & 0x3ff) / 1024.0;
  double value = 0.0;
  if (exponent == 0) {
    value = std::ldexp(fraction, -14);
  } else if (exponent < 31) {
    value = std::ldexp(1.0 + fraction, exponent - 15);
  } else {
    value = fraction == 0.0 ? INFINITY : NAN;
  }
  return (bits & 0x8000) != 0 ? -value : value;
}

std::vector<std::string> SplitAtCommas(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    names.emplace_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return names;
}

MessageField FieldOf(const std::string& name, char letter, std::size_t offset) {
  MessageField field;
  field.name = name;
  field.letter = letter;
  field.offset = offset;
  if (const Letter* number = FindLetter(letter)) {
    field.type = number->type;
    field.divisor = number->divisor;
  }
  return field;
}

void AddField(const std::string& name, char letter, std::size_t offset, MessageFormat* format) {
  if (letter == 'a') {
    for (std::size_t i = 0; i < kArray; ++i) {
      const std::size_t at = offset + i * SizeOf('h');
      if (at + SizeOf('h') > format->length) return;
      format->numbers.push_back(FieldOf(fmt::format("{}[{}]", name, i), 'h', at));
    }
  } else if (offset + SizeOf(letter) <= format->length) {
    auto& fields = IsText(letter) ? format->texts : format->numbers;
    fields.push_back(FieldOf(name, letter, offset));
  }
}

MessageFormat Define(int type,
                     std::size_t length,
                     std::string_view name,
                     std::string_view letters,
                     std::string_view columns) {
  MessageFormat format;
  if (length < kHeader || name.empty()) return format;
  format.type = type;
  format.length = length;
  format.name = name;
  format.columns = SplitAtCommas(columns);
  std::size_t offset = kHeader;
  for (std::size_t i = 0; i < std::min(letters.size(), format.columns.size()); ++i) {
    if (SizeOf(letters[i]) == 0) break;  // where the next field begins, nobody knows
    AddField(format.columns[i], letters[i], offset, &format);
    offset += SizeOf(letters[i]);
  }
  return format;
}

const MessageField* Find(const std::vector<MessageField>& fields, std::string_view name) {
  const auto found = std::find_if(
      fields.begin(), fields.end(), [&](const MessageField& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace

const MessageField* MessageFormat::FindNumber(std::string_view field) const {
  return Find(numbers, field);
}

const MessageField* MessageFormat::FindText(std::string_view field) const {
  return Find(texts, field);
}

MessageFormat FormatOfFmt() {
  return Define(kFmtType, kFmtLength, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns");
}

MessageFormat ParseFmt(std::string_view message) {
  return Define(NumberAt<std::uint8_t>(message, 3),
                NumberAt<std::uint8_t>(message, 4),
                UpToNul(message.substr(5, 4)),
                UpToNul(message.substr(9, 16)),
                UpToNul(message.substr(25, 64)));
}

double ValueOf(const MessageField& number, std::string_view message) {
  if (number.letter == 'g') return Half(NumberAt<std::uint16_t>(message, number.offset));
  return NumberAt(number.type, message, number.offset) / number.divisor * number.multiplier;
}

std::string_view TextOf(const MessageField& text, std::string_view message) {
  return UpToNul(message.substr(text.offset, SizeOf(text.letter)));
}

bool TakesMultiplier(char letter) {
  return std::string_view("bBMhHiIqQ").find(letter) != std::string_view::npos;
}

}  // namespace fathom
