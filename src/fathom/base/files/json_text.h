// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// A JSON file's text, for readers too: two columns a level, a line break at its end. Bytes of names
// that are no UTF-8 become U+FFFD. `Json` is nlohmann::json or its ordered kin.
template <typename Json>
std::string JsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fathom
