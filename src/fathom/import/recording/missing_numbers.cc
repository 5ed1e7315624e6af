// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/missing_numbers.h"

#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace fathom {

void MissingNumbers::Look(const Channel& channel,
                          const std::function<double(std::size_t, std::size_t)>& at) {
  constexpr std::size_t kMostSentences = 50;
  std::uint64_t num_missing = 0;
  std::string first;
  for (std::size_t field = 0; field < channel.fields.size(); ++field) {
    for (std::size_t sample = 0; sample < channel.count; ++sample) {
      if (std::isfinite(at(sample, field))) continue;
      if (num_missing++ > 0) continue;
      first = fmt::format("sample {} of {}", sample + 1, Quoted(channel.fields[field].name));
    }
  }
  if (num_missing == 0) return;
  if (sentences_.size() == kMostSentences) {
    ++num_more_;
    return;
  }
  sentences_.push_back(fmt::format("{}: {} missing, NaN or infinite, the first is {}.",
                                   Printable(channel.name),
                                   Plural(num_missing, "number"),
                                   first));
}

void MissingNumbers::WriteTo(std::vector<std::string>* remarks) const {
  remarks->insert(remarks->end(), sentences_.begin(), sentences_.end());
  if (num_more_ > 0) {
    remarks->push_back(fmt::format("{} more miss numbers.", Plural(num_more_, "channel")));
  }
}

}  // namespace fathom
