// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/structure_file.h"

#include "fathom/base/files/json_text.h"
#include "fathom/comparison/structure_text.h"

#include <array>
#include <cstddef>
#include <optional>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using StructureJson = nlohmann::ordered_json;

StructureJson ByDof(const std::array<double, 6>& values, const std::vector<Dof>& dofs) {
  StructureJson json = StructureJson::object();
  for (const Dof dof : dofs) {
    json[std::string(Name(dof))] = values[static_cast<std::size_t>(Index(dof))];
  }
  return json;
}

StructureJson JsonOf(const std::optional<UnseenGain>& gain) {
  if (!gain) return {};
  return {{"share", gain->share}, {"standard_errors", gain->in_errors}};
}

StructureJson JsonOf(const StructureRow& row, bool is_taken, const std::vector<Dof>& dofs) {
  StructureJson json = {{"model", row.is_of_one_dof ? "one_dof_each" : "coupled"}};
  json[row.is_of_one_dof ? "family" : "structure"] = row.name;
  if (!row.of_families.empty()) json["families"] = row.of_families;
  if (!row.chosen.empty()) json["chosen"] = row.chosen;
  json.update({{"numbers", row.num_numbers},
               {"nmae", ByDof(row.train_nmae, dofs)},
               {"heldout_nmae", ByDof(row.held_out_nmae, dofs)},
               {"unseen_nmae", ByDof(row.unseen_nmae, dofs)},
               {"nearer_than_one_dof_each", JsonOf(row.gain)},
               {"nearer_than_taken", JsonOf(row.gain_over_taken)},
               {"seconds", row.seconds},
               {"usable", row.is_usable},
               {"taken", is_taken},
               {"message", row.message}});
  return json;
}

}  // namespace

std::string FormatStructures(const StructureComparison& comparison) {
  StructureJson dofs = StructureJson::array(), rows = StructureJson::array();
  for (const Dof dof : comparison.dofs) dofs.push_back(Name(dof));
  const StructureRow* const taken = comparison.Taken();
  for (const StructureRow& row : comparison.rows) {
    rows.push_back(JsonOf(row, &row == taken, comparison.dofs));
  }
  const StructureJson json = {{"schema", "fathom-structures-1"},
                              {"log", comparison.log_name},
                              {"dofs", dofs},
                              {"window", comparison.window},
                              {"sentence", StructureSentence(comparison)},
                              {"rows", rows},
                              {"remarks", comparison.remarks}};
  return JsonText(json);
}

}  // namespace fathom
