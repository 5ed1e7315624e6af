// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/path_text.h"

#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

// Bytes of the UTF-8 character at the begin of `text`; 0 if there is none, or one that is written
// longer than it need be, a surrogate or beyond U+10FFFF.
std::size_t LengthOfCharacter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  if (first == 0xE0 && byte(1) < 0xA0) return 0;
  if (first == 0xED && byte(1) > 0x9F) return 0;
  if (first == 0xF0 && byte(1) < 0x90) return 0;
  if (first == 0xF4 && byte(1) > 0x8F) return 0;
  return length;
}

std::string Clean(std::string_view text, bool is_path) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = LengthOfCharacter(text);
    const auto first = static_cast<unsigned char>(text[0]);
    const bool is_control = first < 0x20 || first == 0x7F;
    if (length == 0 || (is_control && (is_path || (first != '\n' && first != '\t')))) {
      clean += fmt::format("\\x{:02x}", first);
      text.remove_prefix(1);
      continue;
    }
    if (is_path && first == '\\') clean += '\\';
    clean += text.substr(0, length);
    text.remove_prefix(length);
  }
  return clean;
}

}  // namespace

std::string PathText(const std::filesystem::path& path) { return Clean(path.string(), true); }

std::string CleanText(std::string_view text) { return Clean(text, false); }

}  // namespace fathom
