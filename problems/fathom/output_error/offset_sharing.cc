// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/offset_sharing.h"

#include "fathom/base/input_error.h"

#include <map>

namespace fathom {

std::string_view Name(OffsetScope scope) {
  return scope == OffsetScope::kShared ? "shared" : "per_log";
}

OffsetScope ParseOffsetScope(const std::string& name) {
  for (const OffsetScope scope : {OffsetScope::kShared, OffsetScope::kPerLog}) {
    if (Name(scope) == name) return scope;
  }
  throw InputError("is '" + name + "', expected one of shared, per_log.");
}

OffsetSharing OneOffsetPerLog(std::span<const std::size_t> log_of) {
  std::map<std::size_t, std::size_t> number;
  OffsetSharing sharing;
  for (const std::size_t log : log_of) {
    sharing.offset_of.push_back(number.try_emplace(log, number.size()).first->second);
  }
  return sharing;
}

}  // namespace fathom
