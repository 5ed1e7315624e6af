// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/numpy/numpy_number.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fathom {
namespace {

// Ticks per second of "[ns]"; nothing for a unit that is no part of a second.
std::optional<double> TicksOf(std::string_view unit) {
  if (unit == "[s]") return 1.0;
  if (unit == "[ms]") return 1e3;
  if (unit == "[us]") return 1e6;
  if (unit == "[ns]") return 1e9;
  return std::nullopt;
}

double SecondsOf(std::int64_t ticks, double per_second) {
  if (ticks == std::numeric_limits<std::int64_t>::min()) return NAN;  // "NaT"
  const auto whole = static_cast<std::int64_t>(per_second);
  return static_cast<double>(ticks / whole) + static_cast<double>(ticks % whole) / per_second;
}

// Of an IEEE 754 binary16: a sign, 5 bits of the exponent and 10 of the fraction.
double HalfOf(std::uint16_t bits) {
  const int exponent = (bits >> 10) & 0x1f;
  const int fraction = bits & 0x3ff;
  const double size = exponent == 0      ? std::ldexp(fraction, -24)
                      : exponent == 0x1f ? (fraction == 0 ? INFINITY : NAN)
                                         : std::ldexp(fraction + 0x400, exponent - 25);
  return (bits & 0x8000) == 0 ? size : -size;
}

}  // namespace

std::optional<NumpyType> ParseNumpyType(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  const char order = text.front();
  if (order != '<' && order != '>' && order != '|' && order != '=') return std::nullopt;
  const char kind = text[1];
  if (std::string_view("fiubcmMOSUVa").find(kind) == std::string_view::npos) {
    return std::nullopt;
  }
  NumpyType type;
  if (kind == 'O' && text.size() == 2) {
    type.size = 8;
    return type;
  }
  std::uint32_t size = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + 2, end, size);
  if (parsed.ec != std::errc() || size > (1U << 29)) return std::nullopt;
  const std::string_view rest(parsed.ptr, static_cast<std::size_t>(end - parsed.ptr));
  const bool is_date = kind == 'M' || kind == 'm';
  if (!rest.empty() && !is_date) return std::nullopt;
  type.size = kind == 'U' ? std::size_t{4} * size : size;
  if (kind == 'f' && size == 2) {  // a half, which is read out of its bits
    type.number = NumpyNumber{'e', NumberType::kUint16, order == '>'};
    return type;
  }
  const char stored = is_date ? 'i' : kind == 'b' && size == 1 ? 'u' : kind;
  const auto number = NumberTypeOf(stored, size);
  const auto ticks = is_date ? TicksOf(rest) : 1.0;
  if (number && ticks && (!is_date || size == 8)) {
    type.number = NumpyNumber{kind, *number, order == '>', *ticks};
  }
  return type;
}

double ValueOf(const NumpyNumber& number, std::string_view bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < SizeOf(number.type)) return NAN;
  if (number.kind == 'e') return HalfOf(NumberAt<std::uint16_t>(bytes, offset, number.is_big));
  if (number.kind == 'b') return bytes[offset] != 0 ? 1.0 : 0.0;
  if (number.kind == 'M' || number.kind == 'm') {
    return SecondsOf(NumberAt<std::int64_t>(bytes, offset, number.is_big), number.per_second);
  }
  return NumberAt(number.type, bytes, offset, number.is_big);
}

}  // namespace fathom
