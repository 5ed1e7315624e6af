// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/csv/refuse_utf16.h"

#include "fathom/base/input_error.h"

#include <cstddef>
#include <filesystem>

#include <fmt/format.h>

namespace fathom {
namespace {

// What iconv calls the encoding; empty for another one.
std::string_view Utf16Of(std::string_view text) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return "UTF-16";
  if (text.size() < 4) return "";
  const auto is_ascii = [&](std::size_t at) { return text[at] >= ' ' && text[at] <= '~'; };
  if (text[0] == 0 && is_ascii(1) && text[2] == 0 && is_ascii(3)) return "UTF-16BE";
  if (is_ascii(0) && text[1] == 0 && is_ascii(2) && text[3] == 0) return "UTF-16LE";
  return "";
}

}  // namespace

void RefuseUtf16(const std::string& name, std::string_view text) {
  const std::string_view encoding = Utf16Of(text);
  if (encoding.empty()) return;
  throw InputError(
      fmt::format("{}:1: is UTF-16, expected plain text. Convert it (iconv -f {} -t UTF-8 {} > "
                  "converted.csv).",
                  name,
                  encoding,
                  std::filesystem::path(name).filename().string()));
}

}  // namespace fathom
