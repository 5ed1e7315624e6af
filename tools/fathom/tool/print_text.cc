// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/print_text.h"

#include "fathom/base/quoted.h"
#include "fathom/tool/wrapped_text.h"

#include <unistd.h>

namespace fathom {

void PrintText(std::FILE* stream, const std::string& text) {
  constexpr std::size_t kWidth = 100;
  const bool is_terminal = isatty(fileno(stream)) == 1;
  const std::string shown = ShownOnLines(text);
  std::fputs((is_terminal ? WrappedText(shown, kWidth) : shown).c_str(), stream);
}

}  // namespace fathom
