// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "confusion_matrix.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <map>

#include <fmt/format.h>

namespace fathom::hidden {
namespace {

constexpr int kGroup = -1, kOther = -2, kAbstained = -3;

// Place in the catalogue.
int ColumnOf(std::string_view effect) {
  const auto catalogue = EffectCatalogue();
  for (std::size_t i = 0; i < catalogue.size(); ++i) {
    if (catalogue[i]->info().name == effect) return static_cast<int>(i);
  }
  return kOther;
}

std::string Letter(int column) {
  return column < 26 ? std::string(1, static_cast<char>('a' + column))
                     : std::string(1, static_cast<char>('A' + column - 26));
}

int ColumnOf(const LogScore& score) {
  const std::string hidden = score.effects.empty() ? "" : score.effects.front();
  switch (score.outcome) {
    case Outcome::kAlone:
      return ColumnOf(hidden);
    case Outcome::kGroup:
      return kGroup;
    case Outcome::kAbstained:
      return kAbstained;
    case Outcome::kWrong:
      for (const std::string& effect : score.certain) {
        if (effect != hidden) return ColumnOf(effect);
      }
      return ColumnOf(score.certain.front());  // the right effect with the wrong partner
    default:
      return kOther;
  }
}

}  // namespace

std::string ConfusionMatrix(const std::vector<LogScore>& scores, bool separable) {
  std::map<int, std::map<int, int>> count;  // [row][column]; row kAbstained: nothing hidden
  for (const LogScore& score : scores) {
    const bool is_nothing = score.hidden == HiddenClass::kNothing;
    if (!is_nothing && score.hidden != HiddenClass::kOneEffect) continue;
    const bool is_sure = score.oracle.IsClear() && score.oracle.IsSeparable();
    if (is_nothing ? !separable : is_sure != separable) continue;
    ++count[is_nothing ? kAbstained : ColumnOf(score.effects.front())][ColumnOf(score)];
  }
  const int num_effects = static_cast<int>(EffectCatalogue().size());
  std::string text = fmt::format("    {:26}", "");
  for (int column = 0; column < num_effects; ++column) text += fmt::format("{:>3}", Letter(column));
  text += "  group other abstained\n";
  const auto add_row = [&](const std::string& name, int row) {
    if (!count.count(row)) return;
    const auto cell = [&](int column) {
      const auto found = count[row].find(column);
      return found == count[row].end() ? std::string(".") : std::to_string(found->second);
    };
    text += fmt::format("    {:26}", name);
    for (int column = 0; column < num_effects; ++column) text += fmt::format("{:>3}", cell(column));
    text += fmt::format("{:>7}{:>6}{:>10}\n", cell(kGroup), cell(kOther), cell(kAbstained));
  };
  for (int row = 0; row < num_effects; ++row) {
    add_row(fmt::format("{} {}", Letter(row), EffectCatalogue()[row]->info().name), row);
  }
  add_row("  nothing", kAbstained);
  return text;
}

}  // namespace fathom::hidden
