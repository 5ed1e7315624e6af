// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/numpy/npy_header.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/numpy/python_literal.h"

#include <optional>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

using Kind = PythonLiteral::Kind;

constexpr std::string_view kNpyMagic = "\x93NUMPY";
constexpr std::size_t kLargestElement = std::size_t{1} << 31;  // [bytes]

[[noreturn]] void RefuseHeader(const std::string& name, const std::string& what) {
  throw InputError(fmt::format("{}: {}.", name, what));
}

std::uint64_t ByteAt(std::string_view bytes, std::size_t index) {
  return static_cast<unsigned char>(bytes[index]);
}

// Puts the fields of a `descr` into a header.
class DescriptionReader {
 public:
  DescriptionReader(const std::string& name, NpyHeader* header) : name_(name), header_(*header) {}

  // Of an element, or a field of one, that begins at `offset`; gives its size.
  std::size_t Add(const PythonLiteral& type, const std::string& field, std::size_t offset) {
    if (type.kind == Kind::kText) return AddNumber(type.text, field, offset);
    if (type.kind != Kind::kList) Refuse("a list or a text");
    std::size_t size = 0;
    for (const PythonLiteral& item : type.items) {
      size += AddField(item, field, offset + size);
      if (size > kLargestElement) Refuse("elements of less than 2 GB");
    }
    return size;
  }

 private:
  [[noreturn]] void Refuse(const std::string& expected) const {
    RefuseHeader(name_, "the 'descr' of its header is of no known form, expected " + expected);
  }

  std::size_t AddNumber(const std::string& text, const std::string& field, std::size_t offset) {
    const auto type = ParseNumpyType(text);
    if (!type) Refuse("a type as '<f8', found " + Quoted(text));
    if (type->number) {
      if (header_.fields.size() >= kMostNpyFields) Refuse("at most 100000 numbers in an element");
      header_.fields.push_back({field, *type->number, offset});
    } else if (text[1] != 'V') {  // V: bytes between fields
      if (++header_.num_others > kMostNpyFields) Refuse("at most 100000 fields in an element");
    }
    return type->size;
  }

  // (name, type) or (name, type, shape); a name may be (title, name).
  std::size_t AddField(const PythonLiteral& item, const std::string& parent, std::size_t offset) {
    const auto& parts = item.items;
    if (item.kind != Kind::kTuple || parts.size() < 2 || parts.size() > 3) {
      Refuse("fields of the form (name, type)");
    }
    const PythonLiteral& named =
        parts[0].kind == Kind::kTuple && parts[0].items.size() == 2 ? parts[0].items[1] : parts[0];
    if (named.kind != Kind::kText) Refuse("fields with names");
    const std::string name = parent.empty() ? named.text : parent + "." + named.text;
    if (parts.size() == 2) return Add(parts[1], name, offset);
    std::uint64_t count = 1;
    const bool is_vector = parts[2].kind == Kind::kNumber;
    for (const PythonLiteral& length : is_vector ? std::vector{parts[2]} : parts[2].items) {
      if (length.kind != Kind::kNumber || length.number > kMostNpyFields)
        Refuse("shapes of fields");
      count *= length.number;
      if (count > kMostNpyFields) Refuse("fields of at most 100000 numbers");
    }
    std::size_t size = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::size_t before = header_.fields.size() + header_.num_others;
      size += Add(parts[1], fmt::format("{}.{}", name, i + 1), offset + size);
      if (size > kLargestElement) Refuse("elements of less than 2 GB");
      // Empty types within each other would take as long as their shapes say.
      if (header_.fields.size() + header_.num_others == before) ++num_empty_;
      if (num_empty_ > kMostNpyFields) Refuse("fields that hold something");
    }
    return size;
  }

  const std::string& name_;
  NpyHeader& header_;
  std::uint64_t num_empty_ = 0;
};

}  // namespace

bool LooksLikeNpy(std::string_view first_bytes) { return first_bytes.starts_with(kNpyMagic); }

NpyHeader ParseNpyHeader(const std::string& name, std::string_view first_bytes) {
  constexpr std::size_t kVersionAt = 6;
  constexpr std::size_t kLengthAt = 8;
  if (!LooksLikeNpy(first_bytes)) RefuseHeader(name, "is no .npy, expected an array of numpy");
  if (first_bytes.size() < 12) RefuseHeader(name, "ends within its header");
  const std::uint64_t version = ByteAt(first_bytes, kVersionAt);
  if (version < 1 || version > 3) {
    RefuseHeader(name, fmt::format("is a .npy of version {}, expected 1, 2 or 3", version));
  }
  std::uint64_t length = ByteAt(first_bytes, 8) | ByteAt(first_bytes, 9) << 8;
  if (version > 1) length |= ByteAt(first_bytes, 10) << 16 | ByteAt(first_bytes, 11) << 24;
  const std::size_t begin = kLengthAt + (version == 1 ? 2 : 4);
  if (length > kMostNpyHeader - begin) {
    RefuseHeader(name, fmt::format("its header has {} bytes, expected at most 1 MB", length));
  }
  if (first_bytes.size() - begin < length) RefuseHeader(name, "ends within its header");
  const auto dictionary =
      ParsePythonLiteral(first_bytes.substr(begin, static_cast<std::size_t>(length)));
  const PythonLiteral* type = dictionary ? dictionary->Find("descr") : nullptr;
  const PythonLiteral* order = dictionary ? dictionary->Find("fortran_order") : nullptr;
  const PythonLiteral* shape = dictionary ? dictionary->Find("shape") : nullptr;
  if (type == nullptr || order == nullptr || shape == nullptr || order->kind != Kind::kTruth ||
      shape->kind != Kind::kTuple) {
    RefuseHeader(name,
                 "its header is damaged, expected a dictionary of Python with 'descr', "
                 "'fortran_order' and 'shape'");
  }
  NpyHeader header;
  header.size = begin + static_cast<std::size_t>(length);
  header.is_fortran = order->number != 0;
  header.is_structured = type->kind == Kind::kList;
  for (const PythonLiteral& item : shape->items) {
    if (item.kind != Kind::kNumber) RefuseHeader(name, "its 'shape' holds no numbers");
    header.shape.push_back(item.number);
  }
  header.element_size = DescriptionReader(name, &header).Add(*type, "", 0);
  return header;
}

}  // namespace fathom
