// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/matlab/mat5_file.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/import/matlab/mat5_arrays.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/inflated.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMat5Header = 128;  // [bytes]
constexpr std::size_t kMat5Tag = 8;

// The bytes of a variable, with its tag. Nothing where it is cut, compressed and damaged, or larger
// than kMostMatlabBytes.
std::optional<std::string> LoadVariable(ByteFile* file, MatlabByteOrder order, std::uint64_t at) {
  const std::string tag(file->View(at, kMat5Tag));
  if (tag.size() < kMat5Tag) return std::nullopt;
  const std::uint64_t size = order.Uint32At(tag, 4);
  if (size > file->size() - at - kMat5Tag) return std::nullopt;
  if (order.Uint32At(tag, 0) == kMat5Compressed) {
    return Inflated(file, at + kMat5Tag, size, kMostMatlabBytes);
  }
  if (size > kMostMatlabBytes) return std::nullopt;
  return file->Copy(at, kMat5Tag + size);
}

class Mat5File final : public MatlabFile {
 public:
  explicit Mat5File(const std::filesystem::path& path);

  std::string format() const override { return "mat5"; }

  const MatlabListing& listing() const override { return listing_; }

  MatlabNumbers Numbers(const MatlabArray& array, MatlabVariable* variable) const override;

 private:
  void List(ByteFile* file);
  void ListVariable(ByteFile* file, std::uint64_t at, std::uint64_t size);

  std::filesystem::path path_;
  MatlabByteOrder order_;
  MatlabListing listing_;
};

Mat5File::Mat5File(const std::filesystem::path& path) : path_(path) {
  ByteFile file(path);
  const std::string_view header = file.View(0, kMat5Header);
  if (header.size() < kMat5Header) {
    throw InputError(fmt::format("{}: ends at byte {}, expected the header of a .mat of {} bytes.",
                                 path.string(),
                                 file.size(),
                                 kMat5Header));
  }
  order_.is_big = header.substr(126) == "MI";
  List(&file);
}

void Mat5File::List(ByteFile* file) {
  std::uint64_t at = kMat5Header;
  const auto stop = [&](const std::string& why) {
    const std::uint64_t left = file->size() - at;
    listing_.Remark(
        fmt::format("{}: the {} from byte {} on are not read.", why, Plural(left, "byte"), at));
    listing_.damaged_bytes += left;
  };
  while (at < file->size()) {
    const std::string tag(file->View(at, kMat5Tag));
    if (tag.size() < kMat5Tag) return stop("the file ends within a variable");
    const std::uint32_t type = order_.Uint32At(tag, 0);
    const std::uint64_t size = kMat5Tag + order_.Uint32At(tag, 4);
    if (type != kMat5Matrix && type != kMat5Compressed) {
      return stop(fmt::format("there is an element of type {}, expected a variable", type));
    }
    if (size > file->size() - at) return stop("the file ends within a variable");
    if (type == kMat5Matrix && size > kMostMatlabBytes) {
      listing_.Remark(
          fmt::format("the variable at byte {} takes more than 200 MB: passed over.", at));
    } else {
      ListVariable(file, at, size);
    }
    at += size;
  }
}

void Mat5File::ListVariable(ByteFile* file, std::uint64_t at, std::uint64_t size) {
  const auto bytes = LoadVariable(file, order_, at);
  if (!bytes) {
    listing_.Remark(
        fmt::format("the variable at byte {} is damaged, or takes more than 200 MB: the {} of it "
                    "are passed over.",
                    at,
                    Plural(size, "byte")));
    listing_.damaged_bytes += size;
    return;
  }
  try {
    ListMat5Arrays(*bytes, order_, at, &listing_);
  } catch (const InputError& error) {
    listing_.Remark(std::string(error.what()) + " What lies before it is read.");
    listing_.damaged_bytes += size;
  }
}

MatlabNumbers Mat5File::Numbers(const MatlabArray& array, MatlabVariable* variable) const {
  if (variable->place != array.variable) {
    variable->bytes.reset();
    ByteFile file(path_);
    auto bytes = LoadVariable(&file, order_, array.variable);
    if (!bytes || bytes->size() < array.offset + array.num_bytes()) {
      throw InputError(path_.string() + ": has changed since it was opened.");
    }
    *variable = {array.variable, std::make_shared<const std::string>(*std::move(bytes))};
  }
  return {variable->bytes, array.offset, array.type, order_};
}

}  // namespace

bool LooksLikeMat5(std::string_view first_bytes) {
  if (!first_bytes.starts_with("MATLAB")) return false;
  if (first_bytes.size() < kMat5Header) return true;  // cut
  // The major version; 2 is HDF5's.
  const bool is_big = first_bytes.substr(126, 2) == "MI";
  return first_bytes[is_big ? 124 : 125] == 1;
}

std::unique_ptr<MatlabFile> OpenMat5(const std::filesystem::path& path) {
  return std::make_unique<Mat5File>(path);
}

}  // namespace fathom
