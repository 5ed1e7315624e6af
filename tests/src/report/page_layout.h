// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <vector>

namespace fathom {

// How a page is looked at.
struct PageLook {
  int width = 1400;         // of the frame it stands in, or of the paper between its margins [px]
  bool is_printed = false;  // with the style of paper
  bool is_dark = false;
};

// A4 between Chromium's margins of 1 cm, at 96 dots per inch [px].
inline constexpr int kPaperWidth = 718;

// What is wrong with the layout of a page in each of the looks, by name; all are empty on a good
// page. The looks are frames of one window: a browser takes a second to begin.
//
//   overflow   elements that reach beyond the frame, and those that hide a part of themselves;
//              everything that folds is opened too
//   errors     errors of scripts, and what they wrote to the console as one
//   unlabelled charts without an aria-label
//   screen     on paper: what only serves a screen
std::vector<std::map<std::string, std::string>> FaultsOf(const std::string& html,
                                                         const std::vector<PageLook>& looks);

}  // namespace fathom
