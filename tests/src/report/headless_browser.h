// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/page.h"

#include <map>
#include <string>

namespace fathom {

// The path of Chromium; empty if it is not installed.
std::string Chromium();

// The page in a real browser, as it stands after its script has run: page.js uses itself when the
// address ends in #selftest and writes what it finds into the page.
std::string DomOf(const Page& page);

// A window, and the clock of the page in it.
struct Window {
  int width = 1280;  // below 500 the page is opened within a frame of this width
  int height = 1000;
  bool has_real_time = false;  // otherwise timers fire at once, and clocks mean nothing
  std::string hash = "#selftest";
};

// The same of any page. With the real clock it is read as soon as it has loaded. Of a page in a
// frame only its findings are read, which it has to post to the window around it.
std::string DomOf(const std::string& html, const Window& window);

// The findings of a reader that acts by `script`, the body of an async function: it fills the
// object `findings`, waits with `await wait()` until all is drawn, and counts with `inkOf(canvas,
// "#0072b2")` the pixels of about that colour.
std::map<std::string, std::string> FindingsOf(const std::string& html, const std::string& script);

// The bytes of the PDF that printing the page gives; empty if there is none.
std::string PrintOf(const std::string& html);

// The lines "name=value" of the element `id`, that of the self test unless it is said.
std::map<std::string, std::string> FindingsIn(const std::string& dom,
                                              const std::string& id = "selftest");

}  // namespace fathom
