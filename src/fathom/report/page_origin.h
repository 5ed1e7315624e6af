// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

struct LogOfPage {
  std::string name;
  std::string span;         // "0.0 s to 299.9 s"; may be empty
  std::string fingerprint;  // of its data, FingerprintOf() (log_fingerprint.h); may be empty
};

// Where a page comes from: how to make it again, and how to tell it from another one.
struct PageOrigin {
  std::string version;  // "Fathom 0.1.0"
  std::string date;     // "2026-11-25 14:31:02"
  std::string command;  // the command line
  std::vector<LogOfPage> logs;
};

// It as a part of a page's header, the same on all pages; nothing if it is empty.
std::string OriginHtml(const PageOrigin& origin);

}  // namespace fathom
