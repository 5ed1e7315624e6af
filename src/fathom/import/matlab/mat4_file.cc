// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/matlab/mat4_file.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/import/recording/byte_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMat4Header = 20;  // [bytes]
constexpr std::uint32_t kLongestMat4Name = 256;

// The types of numbers by the digit P of MOPT.
constexpr std::array<std::pair<NumberType, const char*>, 6> kMat4Types = {
    {{NumberType::kFloat64, "double"},
     {NumberType::kFloat32, "single"},
     {NumberType::kInt32, "int32"},
     {NumberType::kInt16, "int16"},
     {NumberType::kUint16, "uint16"},
     {NumberType::kUint8, "uint8"}}};

// What the header of a variable says.
struct Mat4Header {
  MatlabByteOrder order;
  std::uint32_t precision = 0;  // P of MOPT
  std::uint32_t kind = 0;       // T of MOPT: 0 numbers, 1 text, 2 sparse
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  bool is_complex = false;
  std::string name;
  std::uint64_t data = 0;  // where the numbers begin, from the header on

  // Two numbers of 32 bits and two small factors do not overflow.
  std::uint64_t size() const {
    const std::uint64_t numbers = std::uint64_t{rows} * columns;
    const std::uint64_t size = SizeOf(kMat4Types[precision].first) * (is_complex ? 2U : 1U);
    return numbers > (std::uint64_t{1} << 58) ? ~std::uint64_t{0} : data + numbers * size;
  }
};

bool IsMatlabName(std::string_view name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
         });
}

// Nothing where no variable begins.
std::optional<Mat4Header> ParseMat4Header(std::string_view bytes) {
  if (bytes.size() < kMat4Header) return std::nullopt;
  Mat4Header header;
  // MOPT is M000, M: 0 little, 1 big, and otherwise of machines that are no more.
  std::uint32_t mopt = header.order.Uint32At(bytes, 0);
  if (mopt >= 100) {
    header.order.is_big = true;
    mopt = header.order.Uint32At(bytes, 0);
    if (mopt < 1000 || mopt >= 1100) return std::nullopt;
    mopt -= 1000;
  }
  header.precision = mopt / 10;
  header.kind = mopt % 10;
  header.rows = header.order.Uint32At(bytes, 4);
  header.columns = header.order.Uint32At(bytes, 8);
  const std::uint32_t imaginary = header.order.Uint32At(bytes, 12);
  const std::uint32_t length = header.order.Uint32At(bytes, 16);
  if (header.precision >= kMat4Types.size() || header.kind > 2 || imaginary > 1 || length == 0 ||
      length > kLongestMat4Name || bytes.size() < kMat4Header + length) {
    return std::nullopt;
  }
  header.is_complex = imaginary == 1;
  const std::string_view name = bytes.substr(kMat4Header, length);
  header.name = name.substr(0, name.find('\0'));
  header.data = kMat4Header + length;
  if (!IsMatlabName(header.name)) return std::nullopt;
  return header;
}

class Mat4File final : public MatlabFile {
 public:
  explicit Mat4File(const std::filesystem::path& path);

  std::string format() const override { return "mat4"; }

  const MatlabListing& listing() const override { return listing_; }

  MatlabNumbers Numbers(const MatlabArray& array, MatlabVariable* variable) const override;

 private:
  void AddVariable(const Mat4Header& header, std::uint64_t begin);

  std::filesystem::path path_;
  MatlabByteOrder order_;
  MatlabListing listing_;
};

Mat4File::Mat4File(const std::filesystem::path& path) : path_(path) {
  ByteFile file(path);
  std::uint64_t at = 0;
  while (at < file.size()) {
    const auto header = ParseMat4Header(file.View(at, kMat4Header + kLongestMat4Name));
    if (!header || (at > 0 && header->order.is_big != order_.is_big)) {
      if (at == 0) {
        throw InputError(path.string() +
                         ": byte 0 begins no variable, expected the header of a "
                         "variable of a .mat of version 4.");
      }
      listing_.Remark(
          fmt::format("byte {} begins no variable, expected the header of one: the {} "
                      "from there on are not read.",
                      at,
                      Plural(file.size() - at, "byte")));
      listing_.damaged_bytes = file.size() - at;
      return;
    }
    order_ = header->order;
    if (header->size() > file.size() - at) {
      listing_.Remark(
          fmt::format("the file ends within variable {}: the {} from byte {} on are not "
                      "read.",
                      header->name,
                      Plural(file.size() - at, "byte"),
                      at));
      listing_.damaged_bytes = file.size() - at;
      return;
    }
    AddVariable(*header, at);
    at += header->size();
  }
}

void Mat4File::AddVariable(const Mat4Header& header, std::uint64_t begin) {
  if (header.kind == 1) {
    listing_.AddText();
  } else if (header.kind == 2) {
    listing_.PassOver(header.name, "is sparse");
  } else if (header.is_complex) {
    listing_.PassOver(header.name, "is complex");
  } else {
    MatlabArray array;
    array.name = header.name;
    array.class_name = kMat4Types[header.precision].second;
    array.type = kMat4Types[header.precision].first;
    array.rows = header.rows;
    array.columns = header.columns;
    array.variable = begin + header.data;
    listing_.Add(std::move(array));
  }
}

MatlabNumbers Mat4File::Numbers(const MatlabArray& array, MatlabVariable* variable) const {
  if (variable->place != array.variable) {
    variable->bytes.reset();
    ByteFile file(path_);
    auto bytes = std::make_shared<std::string>(file.Copy(array.variable, array.num_bytes()));
    if (bytes->size() < array.num_bytes()) {
      throw InputError(path_.string() + ": is shorter than it was when opened.");
    }
    *variable = {array.variable, std::move(bytes)};
  }
  return {variable->bytes, 0, array.type, order_};
}

}  // namespace

bool LooksLikeMat4(std::string_view first_bytes) {
  return ParseMat4Header(first_bytes).has_value();
}

std::unique_ptr<MatlabFile> OpenMat4(const std::filesystem::path& path) {
  return std::make_unique<Mat4File>(path);
}

}  // namespace fathom
