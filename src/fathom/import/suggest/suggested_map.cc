// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/suggested_map.h"

#include "fathom/base/files/json_text.h"

#include <nlohmann/json.hpp>

namespace fathom {

bool SuggestedMap::NamesAStream() const {
  for (const char* const stream : {"command:", "velocity:", "pose:", "camera:"}) {
    if (text.starts_with(stream) || text.find(std::string("\n") + stream) != std::string::npos) {
      return true;
    }
  }
  return false;
}

std::string FormatSuggestion(const SuggestedMap& map) {
  using Json = nlohmann::ordered_json;
  return JsonText(Json{{"schema", "fathom-suggestion-1"},
                       {"ready", map.is_ready},
                       {"needs_vehicle", map.needs_vehicle},
                       {"map", map.text}});
}

}  // namespace fathom
