// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/matlab/mat5_arrays.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kTag = 8;            // [bytes]
constexpr std::size_t kLongestName = 256;  // MATLAB's are of 63 characters at most

// Classes of arrays.
constexpr std::uint32_t kCell = 1;
constexpr std::uint32_t kStruct = 2;
constexpr std::uint32_t kObject = 3;
constexpr std::uint32_t kChar = 4;
constexpr std::uint32_t kSparse = 5;
constexpr std::uint32_t kFirstNumeric = 6;
constexpr std::uint32_t kFunction = 16;
constexpr std::uint32_t kOpaque = 17;
constexpr std::array<const char*, 10> kNumericClasses = {
    "double", "single", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"};

// How the numbers of an element of this type are stored; nothing if it holds none.
std::optional<NumberType> StoredAs(std::uint32_t type) {
  if (type == 7) return NumberType::kFloat32;
  if (type == 9) return NumberType::kFloat64;
  if (type == 12 || type == 13) return NumberTypeOf(type == 12 ? 'i' : 'u', 8);
  if (type < 1 || type > 6) return std::nullopt;
  return NumberTypeOf(type % 2 == 1 ? 'i' : 'u', std::size_t{1} << ((type - 1) / 2));
}

// An element, without its tag.
struct Mat5Element {
  std::uint32_t type = 0;
  std::size_t begin = 0;
  std::size_t size = 0;

  std::size_t end() const { return begin + size; }
};

// What an array is called, and what it is a field of.
struct Mat5Place {
  std::string name;
  std::string parent;
  std::string field;
  int depth = 0;
};

class Mat5Lister {
 public:
  Mat5Lister(std::string_view bytes,
             MatlabByteOrder order,
             std::uint64_t variable,
             MatlabListing* listing)
      : bytes_(bytes), order_(order), variable_(variable), listing_(listing) {}

  void ListVariable() {
    std::size_t at = 0;
    List(Next(&at, bytes_.size()), nullptr);
  }

 private:
  [[noreturn]] void Fail(std::size_t at, const std::string& what) const {
    throw InputError(
        fmt::format("the variable at byte {} is damaged at its byte {}: {}", variable_, at, what));
  }

  // The element at `at`, which lies before `end`; `at` goes to the one behind it.
  Mat5Element Next(std::size_t* at, std::size_t end) const;

  std::string_view TextOf(const Mat5Element& element) const {
    return bytes_.substr(element.begin, element.size);
  }

  // A name, which stands in an element of its own.
  std::string NextName(std::size_t* at, std::size_t end) const;

  std::vector<std::string> FieldNames(std::size_t* at, std::size_t end) const;

  // The product of the dimensions of at most 2^62.
  std::uint64_t CountOf(const std::vector<std::uint32_t>& dimensions, std::size_t at) const;

  // The array in an element kMat5Matrix. `place`: null for a variable, which has a name itself.
  void List(const Mat5Element& matrix, const Mat5Place* place);
  void ListFields(std::size_t at, std::size_t end, std::uint64_t count, const Mat5Place& place);
  void ListCells(std::size_t at, std::size_t end, std::uint64_t count, const Mat5Place& place);
  void ListNumbers(std::size_t at,
                   std::size_t end,
                   const std::vector<std::uint32_t>& dimensions,
                   MatlabArray array);

  std::string_view bytes_;
  MatlabByteOrder order_;
  std::uint64_t variable_;
  MatlabListing* listing_;
};

Mat5Element Mat5Lister::Next(std::size_t* at, std::size_t end) const {
  if (end - *at < kTag) Fail(*at, "it ends, expected an element.");
  Mat5Element element;
  const std::uint32_t first = order_.Uint32At(bytes_, *at);
  if ((first >> 16U) != 0) {
    // A small element: its length is in the upper half, its data in the tag.
    element = {first & 0xffffU, *at + 4, first >> 16U};
    if (element.size > 4) Fail(*at, fmt::format("{} bytes in a small element.", element.size));
    *at += kTag;
    return element;
  }
  element = {first, *at + kTag, order_.Uint32At(bytes_, *at + 4)};
  const std::size_t left = end - element.begin;
  if (element.size > left) {
    Fail(*at, fmt::format("an element of {} bytes, expected {} at most.", element.size, left));
  }
  // Padded to eight bytes, of which the last may be missing at the end.
  const std::size_t padded = (element.size + 7) / 8 * 8;
  *at = element.begin + (padded > left ? left : padded);
  return element;
}

std::string Mat5Lister::NextName(std::size_t* at, std::size_t end) const {
  const std::size_t begin = *at;
  const Mat5Element element = Next(at, end);
  if (element.size > kLongestName) Fail(begin, fmt::format("a name of {} bytes.", element.size));
  return std::string(TextOf(element));
}

std::vector<std::string> Mat5Lister::FieldNames(std::size_t* at, std::size_t end) const {
  const std::size_t begin = *at;
  const Mat5Element length = Next(at, end);
  if (length.size != 4) Fail(begin, "no length of field names.");
  const std::uint32_t step = order_.Uint32At(bytes_, length.begin);
  if (step == 0 || step > kLongestName) Fail(begin, fmt::format("field names of {} bytes.", step));
  const std::string_view all = TextOf(Next(at, end));
  std::vector<std::string> names;
  for (std::size_t i = 0; i + step <= all.size(); i += step) {
    const std::string_view name = all.substr(i, step);
    names.emplace_back(name.substr(0, name.find('\0')));
  }
  return names;
}

std::uint64_t Mat5Lister::CountOf(const std::vector<std::uint32_t>& dimensions,
                                  std::size_t at) const {
  std::uint64_t count = 1;
  for (const std::uint32_t dimension : dimensions) {
    // More than its bytes is damage; a size of 0 may stand anywhere.
    if (dimension != 0 && count > (std::uint64_t{1} << 31)) Fail(at, "more numbers than fit.");
    count *= dimension;
  }
  return count;
}

void Mat5Lister::List(const Mat5Element& matrix, const Mat5Place* place) {
  if (matrix.type != kMat5Matrix) {
    Fail(matrix.begin, fmt::format("an element of type {}, expected an array.", matrix.type));
  }
  Mat5Place own = place == nullptr ? Mat5Place() : *place;
  if (matrix.size == 0) {  // as [] in a cell
    listing_->Add({own.name, "", "", "double"});
    return;
  }
  std::size_t at = matrix.begin;
  const std::size_t end = matrix.end();
  const Mat5Element flags_element = Next(&at, end);
  if (flags_element.size != 8) Fail(matrix.begin, "no flags of an array.");
  const std::uint32_t flags = order_.Uint32At(bytes_, flags_element.begin);
  const std::uint32_t array_class = flags & 0xffU;
  std::vector<std::uint32_t> dimensions;
  if (array_class != kOpaque) {
    const std::size_t begin = at;
    const Mat5Element element = Next(&at, end);
    if (element.size % 4 != 0 || element.size < 8 || element.size > 128) {
      Fail(begin, fmt::format("dimensions of {} bytes.", element.size));
    }
    for (std::size_t i = 0; i < element.size; i += 4) {
      dimensions.push_back(order_.Uint32At(bytes_, element.begin + i));
    }
  }
  const std::uint64_t count = CountOf(dimensions, at);
  const std::string stated_name = NextName(&at, end);
  if (place == nullptr) own.name = stated_name;
  if (array_class == kOpaque) {
    NextName(&at, end);  // the system of types: MCOS, java
    const std::string class_name = NextName(&at, end);
    listing_->PassOver(
        own.name,
        fmt::format("is an object of class {}, which only MATLAB reads", Quoted(class_name)));
  } else if (array_class == kObject) {
    listing_->PassOver(own.name,
                       fmt::format("is an object of class {}, which only MATLAB reads",
                                   Quoted(NextName(&at, end))));
  } else if (array_class == kFunction) {
    listing_->PassOver(own.name, "is a function");
  } else if (array_class == kSparse) {
    listing_->PassOver(own.name, "is sparse");
  } else if (array_class == kChar) {
    listing_->AddText();
  } else if (own.name.empty()) {
    listing_->Remark(fmt::format(
        "the variable at byte {} has no name; it is of MATLAB's own: passed over.", variable_));
  } else if (own.depth > kDeepestMatlabArray) {
    listing_->PassOver(own.name, "lies too deep");
  } else if (array_class == kStruct) {
    ListFields(at, end, count, own);
  } else if (array_class == kCell) {
    ListCells(at, end, count, own);
  } else if (array_class >= kFirstNumeric && array_class < kFirstNumeric + kNumericClasses.size()) {
    constexpr std::uint32_t kLogicalFlag = 0x200;
    constexpr std::uint32_t kComplexFlag = 0x800;
    if ((flags & kComplexFlag) != 0) {
      listing_->PassOver(own.name, "is complex");
      return;
    }
    MatlabArray array;
    array.name = own.name;
    array.parent = own.parent;
    array.field = own.field;
    array.class_name =
        (flags & kLogicalFlag) != 0 ? "logical" : kNumericClasses[array_class - kFirstNumeric];
    ListNumbers(at, end, dimensions, std::move(array));
  } else {
    Fail(matrix.begin, fmt::format("an array of class {}, which there is none of.", array_class));
  }
}

void Mat5Lister::ListFields(std::size_t at,
                            std::size_t end,
                            std::uint64_t count,
                            const Mat5Place& place) {
  const std::vector<std::string> fields = FieldNames(&at, end);
  listing_->TakeFieldNames(place.name, fields);
  if (fields.empty()) return;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string parent = MatlabElementName(place.name, i, count);
    for (const std::string& field : fields) {
      const Mat5Place inner = {parent + "." + field, parent, field, place.depth + 1};
      List(Next(&at, end), &inner);
    }
  }
}

void Mat5Lister::ListCells(std::size_t at,
                           std::size_t end,
                           std::uint64_t count,
                           const Mat5Place& place) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const Mat5Place inner = {fmt::format("{}[{}]", place.name, i + 1), "", "", place.depth + 1};
    List(Next(&at, end), &inner);
  }
}

void Mat5Lister::ListNumbers(std::size_t at,
                             std::size_t end,
                             const std::vector<std::uint32_t>& dimensions,
                             MatlabArray array) {
  const std::size_t begin = at;
  const std::uint64_t count = CountOf(dimensions, at);
  if (count > 0) {
    const Mat5Element numbers = Next(&at, end);
    const auto type = StoredAs(numbers.type);
    if (!type) Fail(begin, fmt::format("an element of type {}, expected numbers.", numbers.type));
    if (count > numbers.size / SizeOf(*type)) {
      Fail(begin, fmt::format("{} bytes of numbers, expected {} numbers.", numbers.size, count));
    }
    array.type = *type;
    array.offset = numbers.begin;
  }
  if (dimensions.size() > 2) {
    listing_->PassOver(array.name, fmt::format("has {} dimensions", dimensions.size()));
    return;
  }
  array.rows = dimensions[0];
  array.columns = dimensions[1];
  array.variable = variable_;
  listing_->Add(std::move(array));
}

}  // namespace

void ListMat5Arrays(std::string_view bytes,
                    MatlabByteOrder order,
                    std::uint64_t variable,
                    MatlabListing* listing) {
  Mat5Lister(bytes, order, variable, listing).ListVariable();
}

}  // namespace fathom
