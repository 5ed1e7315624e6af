// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/numpy/python_literal.h"

#include <charconv>
#include <cstddef>
#include <utility>

namespace fathom {
namespace {

constexpr int kDeepestLiteral = 20;

class LiteralParser {
 public:
  explicit LiteralParser(std::string_view text) : rest_(text) {}

  std::optional<PythonLiteral> Whole() {
    auto literal = Next(0);
    SkipSpaces();
    if (!rest_.empty()) return std::nullopt;
    return literal;
  }

 private:
  using Kind = PythonLiteral::Kind;

  void SkipSpaces() {
    const std::size_t first = rest_.find_first_not_of(" \t\r\n");
    rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
  }

  // Whether this comes next; takes it then.
  bool Takes(std::string_view token) {
    SkipSpaces();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  std::optional<PythonLiteral> Next(int depth);
  std::optional<PythonLiteral> Text(char quote);
  std::optional<PythonLiteral> Number();
  std::optional<PythonLiteral> Items(Kind kind, std::string_view end, int depth);

  std::string_view rest_;
};

std::optional<PythonLiteral> LiteralParser::Next(int depth) {
  if (depth > kDeepestLiteral) return std::nullopt;
  if (Takes("{")) return Items(Kind::kDictionary, "}", depth);
  if (Takes("[")) return Items(Kind::kList, "]", depth);
  if (Takes("(")) return Items(Kind::kTuple, ")", depth);
  if (Takes("True")) return PythonLiteral{Kind::kTruth, "", 1, {}};
  if (Takes("False")) return PythonLiteral{Kind::kTruth, "", 0, {}};
  if (Takes("'")) return Text('\'');
  if (Takes("\"")) return Text('"');
  return Number();
}

std::optional<PythonLiteral> LiteralParser::Text(char quote) {
  PythonLiteral literal;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (rest_[i] == quote) {
      rest_.remove_prefix(i + 1);
      return literal;
    }
    // Python escapes quotes and backslashes alike; other escapes stay as they are written.
    const bool is_escape = rest_[i] == '\\' && i + 1 < rest_.size() &&
                           std::string_view("'\"\\").find(rest_[i + 1]) != std::string_view::npos;
    if (is_escape) ++i;
    literal.text += rest_[i];
  }
  return std::nullopt;
}

std::optional<PythonLiteral> LiteralParser::Number() {
  PythonLiteral literal;
  literal.kind = Kind::kNumber;
  const char* end = rest_.data() + rest_.size();
  const auto parsed = std::from_chars(rest_.data(), end, literal.number);
  if (parsed.ec != std::errc()) return std::nullopt;
  rest_.remove_prefix(static_cast<std::size_t>(parsed.ptr - rest_.data()));
  if (rest_.starts_with("L")) rest_.remove_prefix(1);  // of Python 2
  return literal;
}

std::optional<PythonLiteral> LiteralParser::Items(Kind kind, std::string_view end, int depth) {
  PythonLiteral literal;
  literal.kind = kind;
  while (!Takes(end)) {
    if (!literal.items.empty() && !Takes(",")) return std::nullopt;
    if (!literal.items.empty() && Takes(end)) break;  // a comma behind the last
    auto item = Next(depth + 1);
    if (!item) return std::nullopt;
    literal.items.push_back(*std::move(item));
    if (kind != Kind::kDictionary) continue;
    if (!Takes(":")) return std::nullopt;
    auto value = Next(depth + 1);
    if (!value) return std::nullopt;
    literal.items.push_back(*std::move(value));
  }
  return literal;
}

}  // namespace

const PythonLiteral* PythonLiteral::Find(std::string_view key) const {
  if (kind != Kind::kDictionary) return nullptr;
  for (std::size_t i = 0; i + 1 < items.size(); i += 2) {
    if (items[i].kind == Kind::kText && items[i].text == key) return &items[i + 1];
  }
  return nullptr;
}

std::optional<PythonLiteral> ParsePythonLiteral(std::string_view text) {
  return LiteralParser(text).Whole();
}

}  // namespace fathom
