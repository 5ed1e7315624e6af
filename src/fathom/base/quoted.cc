// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/quoted.h"

#include <cstddef>

namespace fathom {

namespace {

constexpr char kHexDigits[] = "0123456789abcdef";

std::string Escaped(unsigned char byte) {
  return {'\\', 'x', kHexDigits[byte >> 4], kHexDigits[byte & 15]};
}

// ISO 6429: 0 to 1f and 7f; and 80 to 9f, which are c2 80 to c2 9f in UTF-8.
std::string WithoutControls(std::string_view text, std::string_view kept) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
    if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {
      shown += Escaped(byte) + Escaped(next);
      ++i;
    } else if ((byte < 0x20 && kept.find(text[i]) == std::string_view::npos) || byte == 0x7f) {
      shown += Escaped(byte);
    } else {
      shown += text[i];
    }
  }
  return shown;
}

}  // namespace

std::string Printable(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string printable;
  for (const char character : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte >= 0x20 && byte < 0x7f) {
      printable += character;
    } else {
      printable += Escaped(byte);
    }
  }
  if (text.size() > kLongest) printable += "...";
  return printable;
}

std::string ShownOnOneLine(std::string_view text) { return WithoutControls(text, ""); }

std::string ShownOnLines(std::string_view text) { return WithoutControls(text, "\n\t"); }

std::string Quoted(std::string_view text) { return "'" + Printable(text) + "'"; }

}  // namespace fathom
