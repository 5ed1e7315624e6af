// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/numpy/numpy_number.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>

namespace fathom {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename T>
T NumberAt(const char* bytes, bool is_big) {
  std::array<char, sizeof(T)> own;
  std::memcpy(own.data(), bytes, sizeof(T));
  if (is_big) std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

// Ticks per second of "[ns]"; nothing for a unit that is no part of a second.
std::optional<double> TicksOf(std::string_view unit) {
  if (unit == "[s]") return 1.0;
  if (unit == "[ms]") return 1e3;
  if (unit == "[us]") return 1e6;
  if (unit == "[ns]") return 1e9;
  return std::nullopt;
}

bool HasSize(std::size_t size, std::initializer_list<std::size_t> known) {
  return std::find(known.begin(), known.end(), size) != known.end();
}

double SecondsOf(std::int64_t ticks, double per_second) {
  if (ticks == std::numeric_limits<std::int64_t>::min()) return NAN;  // "NaT"
  const auto whole = static_cast<std::int64_t>(per_second);
  return static_cast<double>(ticks / whole) + static_cast<double>(ticks % whole) / per_second;
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
  NumpyNumber number = {kind, size, order == '>', 1.0};
  if (is_date) {
    const auto ticks = TicksOf(rest);
    if (!ticks || size != 8) return type;
    number.per_second = *ticks;
    type.number = number;
  } else if ((kind == 'f' && HasSize(size, {4, 8})) || (kind == 'b' && size == 1) ||
             ((kind == 'i' || kind == 'u') && HasSize(size, {1, 2, 4, 8}))) {
    type.number = number;
  }
  return type;
}

double ValueOf(const NumpyNumber& number, std::string_view bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < number.size) return NAN;
  const char* at = bytes.data() + offset;
  const bool is_big = number.is_big;
  const bool is_signed = number.kind == 'i';
  if (number.kind == 'f') {
    return number.size == 4 ? NumberAt<float>(at, is_big) : NumberAt<double>(at, is_big);
  }
  if (number.kind == 'b') return *at != 0 ? 1.0 : 0.0;
  if (number.kind == 'M' || number.kind == 'm') {
    return SecondsOf(NumberAt<std::int64_t>(at, is_big), number.per_second);
  }
  switch (number.size) {
    case 1:
      return is_signed ? NumberAt<std::int8_t>(at, is_big) : NumberAt<std::uint8_t>(at, is_big);
    case 2:
      return is_signed ? NumberAt<std::int16_t>(at, is_big) : NumberAt<std::uint16_t>(at, is_big);
    case 4:
      return is_signed ? static_cast<double>(NumberAt<std::int32_t>(at, is_big))
                       : static_cast<double>(NumberAt<std::uint32_t>(at, is_big));
    default:
      return is_signed ? static_cast<double>(NumberAt<std::int64_t>(at, is_big))
                       : static_cast<double>(NumberAt<std::uint64_t>(at, is_big));
  }
}

}  // namespace fathom
