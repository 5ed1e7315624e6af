// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/matlab/matlab_file.h"

#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// More is damage, or no log.
constexpr std::size_t kMostArrays = 10'000;
constexpr std::uint64_t kMostFields = 100'000;  // of all arrays
constexpr std::size_t kMostRemarks = 50;

}  // namespace

void MatlabListing::Add(MatlabArray array) {
  if (array.rows == 0 || array.columns == 0) {
    ++num_empty_;
  } else if (array.rows == 1 && array.columns == 1) {
    ++num_scalars_;
  } else if (array.num_bytes() > kMostMatlabBytes) {
    PassOver(array.name, "takes more than 200 MB");
  } else if (arrays_.size() == kMostArrays || num_fields_ + array.num_fields() > kMostFields) {
    PassOver(array.name,
             fmt::format("comes behind {} arrays or {} columns", kMostArrays, kMostFields));
  } else if (!names_.insert(array.name).second) {
    PassOver(array.name, "stands in the file again; the first one is read");
  } else {
    num_fields_ += array.num_fields();
    arrays_.push_back(std::move(array));
  }
}

void MatlabListing::PassOver(std::string_view name, std::string_view why) {
  Remark(fmt::format("{} {}: passed over.", Quoted(name), why));
}

void MatlabListing::Remark(std::string remark) {
  if (num_remarks_++ < kMostRemarks) remarks_.push_back(std::move(remark));
}

void MatlabListing::TakeFieldNames(std::string_view name, std::span<const std::string> fields) {
  const auto has = [&](std::string_view field) {
    return std::find(fields.begin(), fields.end(), field) != fields.end();
  };
  if (!has("time") || !has("signals")) return;
  Remark(fmt::format(
      "{0} is a 'structure with time' of Simulink, whose labels only MATLAB reads. In a "
      "map, 'time: {{channel: {0}.time, field: value}}' gives its stamps.",
      Printable(name)));
}

std::vector<std::string> MatlabListing::Remarks() const {
  std::vector<std::string> remarks = remarks_;
  if (num_remarks_ > remarks_.size()) {
    remarks.push_back(fmt::format("and {} more of the kind.", num_remarks_ - remarks_.size()));
  }
  if (num_scalars_ + num_texts_ + num_empty_ > 0) {
    remarks.push_back(fmt::format("no channels: {}, {}, {}.",
                                  Plural(num_scalars_, "scalar"),
                                  Plural(num_texts_, "text"),
                                  Plural(num_empty_, "empty array")));
  }
  return remarks;
}

std::string MatlabElementName(const std::string& name, std::uint64_t index, std::uint64_t count) {
  return count == 1 ? name : fmt::format("{}[{}]", name, index + 1);
}

}  // namespace fathom
