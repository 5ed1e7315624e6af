// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/contents_json.h"

#include "fathom/base/files/json_text.h"

#include <optional>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json OrNull(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json JsonOf(const Channel& channel) {
  Json fields = Json::array();
  for (const Field& field : channel.fields) {
    fields.push_back({{"name", field.name}, {"unit", field.unit}});
  }
  return {{"name", channel.name},
          {"type", channel.type},
          {"count", channel.count},
          {"first", OrNull(channel.first)},
          {"last", OrNull(channel.last)},
          {"fields", std::move(fields)}};
}

}  // namespace

std::string FormatContents(const Contents& contents) {
  Json json = {{"format", contents.format},
               {"complete", contents.IsComplete()},
               {"read_bytes", contents.read_bytes},
               {"size_bytes", contents.size_bytes},
               {"utc_of_zero", OrNull(contents.utc_of_zero)},
               {"channels", Json::array()},
               {"remarks", contents.remarks}};
  for (const Channel& channel : contents.channels) json["channels"].push_back(JsonOf(channel));
  return JsonText(json);
}

}  // namespace fathom
