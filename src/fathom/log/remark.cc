// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/remark.h"

#include <algorithm>

namespace fathom {

std::vector<std::string> TextsOf(std::span<const Remark> remarks) {
  std::vector<std::string> texts;
  for (const Remark& remark : remarks) texts.push_back(remark.text);
  return texts;
}

bool Holds(std::span<const Remark> remarks, RemarkKind kind) {
  return std::any_of(
      remarks.begin(), remarks.end(), [kind](const Remark& remark) { return remark.kind == kind; });
}

}  // namespace fathom
