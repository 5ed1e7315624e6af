// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/dataflash/message_units.h"

#include "fathom/base/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

// What a log says of its units, by the letters that stand for them.
struct UnitTables {
  std::map<char, std::string> labels;
  std::map<char, double> multipliers;
  struct Letters {
    std::string units;
    std::string multipliers;
  };
  std::map<int, Letters> of_type;
};

std::optional<char> IdOf(const MessageFormat& format, std::string_view message) {
  const MessageField* id = format.FindNumber("Id");
  if (id == nullptr) return std::nullopt;
  const double value = ValueOf(*id, message);
  if (!(value >= 0.0 && value <= 127.0)) return std::nullopt;
  return static_cast<char>(value);
}

// ArduPilot writes 1e-6 as a float that became a double: 9.999999974752427e-07. It means the
// decimal number nearby.
double RoundedToSixDigits(double multiplier) {
  return ParseFiniteNumber(fmt::format("{:.6g}", multiplier)).value_or(1.0);
}

void Take(const MessageFormat& format, std::string_view message, UnitTables* tables) {
  if (format.name == "UNIT") {
    const MessageField* label = format.FindText("Label");
    const auto id = IdOf(format, message);
    if (label == nullptr || !id || *id == '-' || *id == '?') return;
    tables->labels[*id] = TextOf(*label, message);
  } else if (format.name == "MULT") {
    const MessageField* mult = format.FindNumber("Mult");
    const auto id = IdOf(format, message);
    if (mult == nullptr || !id || *id == '-' || *id == '?') return;
    const double multiplier = ValueOf(*mult, message);
    if (std::isfinite(multiplier) && multiplier > 0.0) {
      tables->multipliers[*id] = RoundedToSixDigits(multiplier);
    }
  } else if (format.name == "FMTU") {
    const MessageField* type = format.FindNumber("FmtType");
    const MessageField* units = format.FindText("UnitIds");
    const MessageField* multipliers = format.FindText("MultIds");
    if (type == nullptr || units == nullptr || multipliers == nullptr) return;
    const double number = ValueOf(*type, message);
    if (!(number >= 0.0 && number <= 255.0)) return;
    tables->of_type[static_cast<int>(number)] = {std::string(TextOf(*units, message)),
                                                 std::string(TextOf(*multipliers, message))};
  }
}

// The letter that stands for a field: by its place among all columns. An array's elements
// "D[0]", ... share that of "D".
char LetterFor(const MessageFormat& format, const MessageField& field, const std::string& letters) {
  const std::string column = field.name.substr(0, field.name.find('['));
  const auto found = std::find(format.columns.begin(), format.columns.end(), column);
  const auto index = static_cast<std::size_t>(found - format.columns.begin());
  return index < letters.size() ? letters[index] : '-';
}

void Apply(const UnitTables& tables, MessageFormat* format) {
  const auto letters = tables.of_type.find(format->type);
  if (letters == tables.of_type.end()) return;
  for (MessageField& field : format->numbers) {
    const auto label = tables.labels.find(LetterFor(*format, field, letters->second.units));
    if (label != tables.labels.end()) field.unit = label->second;
    const auto multiplier =
        tables.multipliers.find(LetterFor(*format, field, letters->second.multipliers));
    if (multiplier != tables.multipliers.end() && TakesMultiplier(field.letter)) {
      field.multiplier = multiplier->second;
    }
  }
}

void ScaleStamps(MessageFormat* format) {
  for (MessageField& field : format->numbers) {
    if (field.name != "TimeUS" && field.name != "TimeMS") continue;
    field.multiplier = field.name == "TimeUS" ? 1e-6 : 1e-3;
    field.unit = "s";
  }
}

}  // namespace

void AddUnits(ByteFile* file, MessageFormats* formats) {
  UnitTables tables;
  std::array<bool, 256> is_of_units = {};  // by type
  for (const MessageFormat& format : *formats) {
    const bool is = format.name == "UNIT" || format.name == "MULT" || format.name == "FMTU";
    if (is && format.type >= 0) is_of_units[format.type] = true;
  }
  ForEachMessage(file, *formats, [&](const MessageFormat& format, std::string_view message) {
    if (is_of_units[format.type]) Take(format, message, &tables);
  });
  for (MessageFormat& format : *formats) {
    if (format.type < 0) continue;
    Apply(tables, &format);
    ScaleStamps(&format);
  }
}

}  // namespace fathom
