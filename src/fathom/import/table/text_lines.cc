// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/text_lines.h"

#include "fathom/base/input_error.h"

#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kShortLine = 1 << 12;    // [bytes] looked at first
constexpr std::size_t kLongestLine = 1 << 20;  // [bytes]
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

}  // namespace

TextLines::TextLines(ByteFile* file, std::uint64_t offset, std::int64_t line_number)
    : file_(file), number_(line_number - 1), offset_(offset), next_(offset) {
  if (offset == 0 && file->View(0, kByteOrderMark.size()) == kByteOrderMark) {
    next_ = kByteOrderMark.size();
  }
}

bool TextLines::Next() {
  if (next_ >= file_->size()) return false;
  offset_ = next_;
  ++number_;
  std::string_view bytes = file_->View(offset_, kShortLine);
  std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) {
    bytes = file_->View(offset_, kLongestLine);
    end = bytes.find('\n');
  }
  has_end_ = end != std::string_view::npos;
  if (!has_end_ && bytes.size() == kLongestLine) {
    throw InputError(fmt::format("{}:{}: the line has over {} bytes, expected a table of numbers.",
                                 file_->path().string(),
                                 number_,
                                 kLongestLine));
  }
  text_ = bytes.substr(0, end);
  next_ = offset_ + text_.size() + (has_end_ ? 1 : 0);
  if (text_.ends_with('\r')) text_.remove_suffix(1);
  if (text_.find('\0') != std::string_view::npos) {
    throw InputError(fmt::format("{}:{}: holds a NUL byte, expected text in UTF-8 or ASCII.",
                                 file_->path().string(),
                                 number_));
  }
  return true;
}

}  // namespace fathom
