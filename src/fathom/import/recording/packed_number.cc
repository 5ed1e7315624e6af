// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/packed_number.h"

#include <algorithm>
#include <cmath>

namespace fathom {

std::optional<NumberType> PackedTypeNamed(std::string_view name) {
  if (name == "float") return NumberType::kFloat32;
  if (name == "double") return NumberType::kFloat64;
  if (name == "bool") return NumberType::kUint8;
  if (name == "char") return NumberType::kInt8;
  if (!name.ends_with("_t")) return std::nullopt;
  return NumberTypeNamed(name.substr(0, name.size() - 2));
}

const PackedNumber* FindNumber(const std::vector<PackedNumber>& numbers, std::string_view name) {
  const auto found =
      std::ranges::find_if(numbers, [&](const PackedNumber& n) { return n.name == name; });
  return found == numbers.end() ? nullptr : &*found;
}

double ValueOf(const PackedNumber& number, std::string_view data) {
  const bool is_there =
      data.size() >= number.offset && data.size() - number.offset >= SizeOf(number.type);
  return is_there ? NumberAt(number.type, data, number.offset) : NAN;
}

}  // namespace fathom
