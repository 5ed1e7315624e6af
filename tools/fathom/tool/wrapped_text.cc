// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/wrapped_text.h"

#include <algorithm>

namespace fathom {
namespace {

// Characters, not bytes: every byte of UTF-8 but those that continue a character.
std::size_t Columns(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

std::string_view FirstLine(std::string_view text) { return text.substr(0, text.find('\n')); }

// "-----  ---", which stands below the headings of a table.
bool IsRule(std::string_view line) {
  return line.find("---") != line.npos && line.find_first_not_of("- ") == line.npos;
}

std::size_t IndentOf(std::string_view line, std::size_t width) {
  constexpr std::size_t kPlain = 2;
  const std::size_t gap = line.substr(0, width / 2).rfind("  ");
  if (gap == std::string_view::npos) return kPlain;
  return Columns(line.substr(0, std::min(line.find_first_not_of(' ', gap), line.size())));
}

// Where to break the line, a space behind at least one word of it; npos where there is none.
std::size_t BreakOf(std::string_view line, std::size_t width) {
  const std::size_t first_word = std::min(line.find_first_not_of(' '), line.size());
  std::size_t at = std::string_view::npos;
  for (std::size_t space = line.find(' ', first_word); space != std::string_view::npos;
       space = line.find(' ', space + 1)) {
    if (at != std::string_view::npos && Columns(line.substr(0, space)) > width) break;
    at = space;
  }
  return at;
}

std::string Wrapped(std::string line, std::size_t width) {
  const std::string indent(IndentOf(line, width), ' ');
  std::string text;
  while (Columns(line) > width) {
    const std::size_t at = BreakOf(line, width);
    if (at == std::string::npos) break;
    text += line.substr(0, at) + "\n";
    line = indent + line.substr(std::min(line.find_first_not_of(' ', at), line.size()));
  }
  return text + line;
}

}  // namespace

std::string WrappedText(std::string_view text, std::size_t width) {
  std::string wrapped;
  bool is_in_table = false;
  while (!text.empty()) {
    const std::string_view line = FirstLine(text);
    const bool has_end = line.size() < text.size();
    text.remove_prefix(line.size() + (has_end ? 1 : 0));
    is_in_table = IsRule(FirstLine(text)) || (is_in_table && line.find("  ") != line.npos);
    wrapped += is_in_table ? std::string(line) : Wrapped(std::string(line), width);
    if (has_end) wrapped += "\n";
  }
  return wrapped;
}

}  // namespace fathom
