// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/table/text_lines.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kShortLine = 1 << 12;      // [bytes] looked at first
constexpr std::size_t kLongestLine = 1 << 20;    // [bytes]
constexpr std::size_t kLongestQuoted = 1 << 13;  // [bytes] that a row with line breaks may have
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// Goes over text in which quotes open where a cell begins and close at the next quote that is not
// doubled.
class QuoteWatch {
 public:
  void Take(char c) {
    if (is_open_) {
      if (c == '"') is_open_ = false;
      is_closed_ = !is_open_;
      return;
    }
    const bool is_doubled = c == '"' && is_closed_;
    is_closed_ = false;
    if (is_doubled || (c == '"' && begins_cell_)) is_open_ = true;
    if (c == ' ') return;
    begins_cell_ = c == ',' || c == ';' || c == '\t' || c == '|' || c == '\n';
  }

  bool is_open() const { return is_open_; }

 private:
  bool is_open_ = false;
  bool is_closed_ = false;  // by the character before
  bool begins_cell_ = true;
};

}  // namespace

TextLines::TextLines(ByteFile* file, std::uint64_t offset, std::int64_t line_number)
    : file_(file), number_(0), offset_(offset), next_(offset), next_number_(line_number) {
  if (offset == 0 && file->View(0, kByteOrderMark.size()) == kByteOrderMark) {
    next_ = kByteOrderMark.size();
  }
}

bool TextLines::Next() {
  if (next_ >= file_->size()) return false;
  offset_ = next_;
  number_ = next_number_++;
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
  if (joins_quoted_ && has_end_ && text_.find('"') != std::string_view::npos) TakeQuotedLines();
  if (text_.ends_with('\r')) text_.remove_suffix(1);
  if (text_.find('\0') != std::string_view::npos) {
    throw InputError(fmt::format("{}:{}: holds a NUL byte, expected text in UTF-8 or ASCII.",
                                 file_->path().string(),
                                 number_));
  }
  return true;
}

void TextLines::TakeQuotedLines() {
  QuoteWatch watch;
  for (const char c : text_) watch.Take(c);
  if (!watch.is_open()) return;
  const std::size_t size = text_.size();
  const std::string_view bytes = file_->View(offset_, std::max(size, kLongestQuoted));
  text_ = bytes.substr(0, size);  // the view before may be gone
  for (std::size_t at = size; at < bytes.size(); ++at) {
    watch.Take(bytes[at]);
    if (bytes[at] != '\n' || watch.is_open()) continue;
    text_ = bytes.substr(0, at);
    next_number_ += std::count(text_.begin(), text_.end(), '\n');
    next_ = offset_ + at + 1;
    return;
  }
}

}  // namespace fathom
