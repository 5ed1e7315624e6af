// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/python_words.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

// "fathom_check", not "fathom_check:" nor "fathom_check.".
bool IsProgram(const std::string& word) {
  const auto is_of_name = [](char c) { return c == '_' || (c >= 'a' && c <= 'z'); };
  const std::size_t at = word.starts_with('`') ? 1 : 0;
  return word.compare(at, 7, "fathom_") == 0 &&
         std::all_of(word.begin() + at, word.end(), is_of_name);
}

}  // namespace

std::string InPythonWords(const std::string& text) {
  std::string told;
  bool is_command = false;  // the word before is a program, or a flag of its
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    std::string word = text.substr(begin, end - begin);
    const std::size_t dashes = word.find_first_not_of("(`'");
    const bool is_flag = dashes != std::string::npos && word.compare(dashes, 2, "--") == 0 &&
                         word.size() > dashes + 2;
    if (is_flag && !is_command) word.erase(dashes, 2);
    is_command = IsProgram(word) || (is_flag && is_command);
    told += word;
    if (end < text.size()) told += text[end];
    begin = end + 1;
  }
  return told;
}

std::vector<std::string> InPythonWords(const std::vector<std::string>& texts) {
  std::vector<std::string> told;
  told.reserve(texts.size());
  for (const std::string& text : texts) told.push_back(InPythonWords(text));
  return told;
}

}  // namespace fathom
