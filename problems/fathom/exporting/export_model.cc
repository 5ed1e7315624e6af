// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/export_model.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/json_value.h"
#include "fathom/vehicle/files/model_file.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// Empty if the file does not say.
std::string ValueAt(const std::map<std::string, std::string>& provenance, const std::string& key) {
  const auto found = provenance.find(key);
  return found == provenance.end() ? "" : found->second;
}

constexpr std::array<const char*, 5> kToldKeys = {
    "log", "family", "source", "structure", "version"};

// What a model or verdict file of one DOF tells of its making, which ParseModel() leaves out.
std::map<std::string, std::string> ProvenanceIn(const std::string& name, const std::string& text) {
  const JsonValue file = JsonValue::Parse(name, text);
  if (file.Has("log")) return {{"log", file.Member("log").Text()}};  // a verdict
  std::map<std::string, std::string> provenance;
  const auto told = file.MemberIfThere("provenance");
  if (!told) return provenance;
  for (const char* key : kToldKeys) {
    if (told->Has(key)) provenance[key] = told->Member(key).Text();
  }
  return provenance;
}

// "run_01 and 2 more" of "dives/run_01,dives/run_02,dives/run_03".
std::string ShortNameOf(const std::string& logs) {
  const auto num_more = std::count(logs.begin(), logs.end(), ',');
  std::string first = logs.substr(0, logs.find(','));
  while (first.size() > 1 && first.back() == '/') first.pop_back();
  const std::string name = first.substr(first.find_last_of('/') + 1);
  return num_more == 0 ? name : fmt::format("{} and {} more", name, num_more);
}

// "boat.json: log tank_07, family output_error, version 0.1.0".
std::string SourceLine(const std::string& file,
                       const std::map<std::string, std::string>& provenance) {
  std::vector<std::string> parts;
  for (const char* key : kToldKeys) {
    const std::string value = ValueAt(provenance, key);
    if (!value.empty()) parts.push_back(fmt::format("{} {}", key, value));
  }
  return fmt::format(
      "{}{}", file, parts.empty() ? "" : fmt::format(": {}", fmt::join(parts, ", ")));
}

// NaN of an entry that was not identified.
double StdOf(const FittedCoupledModel& fitted, const FreeEntry& entry) {
  const auto found = std::find(fitted.entries.begin(), fitted.entries.end(), entry);
  if (found == fitted.entries.end()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = static_cast<Eigen::Index>(found - fitted.entries.begin());
  return std::sqrt(fitted.covariance(at, at));
}

// Those that were identified or that act, in the order of a list, but for what is an effect.
std::vector<FreeEntry> NumbersIn(const FittedCoupledModel& fitted) {
  std::vector<FreeEntry> all = EntriesIn(fitted.model);
  all.insert(all.end(), fitted.entries.begin(), fitted.entries.end());
  const auto place = [](const FreeEntry& entry) {
    return std::tuple(entry.kind, entry.row, entry.column, entry.actuator);
  };
  std::ranges::sort(all, {}, place);
  const auto repeated = std::ranges::unique(all);
  all.erase(repeated.begin(), repeated.end());
  std::erase_if(all, [](const FreeEntry& entry) {
    return entry == TimeOffsetEntry() || entry == ThrusterLagEntry() ||
           entry.kind == FreeEntry::Kind::kEffect || IsOfRun(entry);
  });
  return all;
}

// The entry of a parameter of a model of one DOF, by its index in kParameterInfo.
FreeEntry EntryOf(int index, Dof dof) {
  if (index == kInertia) return InertiaEntry(dof, dof);
  if (index == kQuadraticDamping) return QuadraticDampingEntry(dof, dof);
  if (index == kLinearDamping) return LinearDampingEntry(dof, dof);
  return dof == Dof::kHeave ? NetBuoyancyEntry() : OffsetEntry(dof);
}

// "N" also of moments in N m.
std::string SharedUnit(const std::string& force_unit) {
  return force_unit == "N m" ? "N" : force_unit;
}

// What holds for the thrust of every DOF, as an effect of each.
void AddThrustInTime(const FittedCoupledModel& fitted,
                     const std::string& log,
                     ExportModel* exported) {
  const std::array<std::pair<FreeEntry, const char*>, 2> entries = {
      {{TimeOffsetEntry(), "offset"}, {ThrusterLagEntry(), "time_constant"}}};
  for (const auto& [entry, parameter] : entries) {
    const double value = ValueIn(fitted.model, entry);
    if (value == 0.0) continue;
    const std::string name = NameOf(entry);
    for (const Dof dof : fitted.model.dofs) {
      exported->effects.push_back(
          {name, name, dof, {{parameter, value, StdOf(fitted, entry), UnitOf(entry)}}, log});
    }
  }
}

// What acts along one DOF.
void AddEffects(const FittedCoupledModel& fitted, const std::string& log, ExportModel* exported) {
  for (const FreeEntry& entry : EntriesIn(fitted.model)) {
    if (entry.kind != FreeEntry::Kind::kEffect) continue;
    const EffectInfo& info = entry.effect->info();
    exported->effects.push_back({std::string(info.name),
                                 NameOf(entry),
                                 entry.row,
                                 {{std::string(info.parameters.front().name),
                                   ValueIn(fitted.model, entry),
                                   StdOf(fitted, entry),
                                   UnitOf(entry, fitted.force_unit)}},
                                 log});
  }
}

// Its parameters stand in the covariance from `first` on.
ExportEffect EffectOf(const ActiveEffect& active,
                      const FittedModel& fitted,
                      Eigen::Index first,
                      const std::string& log) {
  const EffectInfo& info = active.effect->info();
  ExportEffect effect = {
      std::string(info.name), LabelOf(info, active.setting), fitted.dof, {}, log};
  for (std::size_t k = 0; k < info.parameters.size(); ++k) {
    const Eigen::Index at = first + static_cast<Eigen::Index>(k);
    const bool is_known = at < fitted.covariance.rows();
    effect.values.push_back(
        {std::string(info.parameters[k].name),
         active.values[k],
         is_known ? std::sqrt(fitted.covariance(at, at)) : std::numeric_limits<double>::quiet_NaN(),
         UnitOf(info.parameters[k].quantity, fitted.dof, fitted.force_unit)});
  }
  return effect;
}

void AddOneDof(const FittedModel& fitted, const std::string& file, ExportModel* exported) {
  const ParameterVector values = ToVector(fitted.model);
  const std::string log = ShortNameOf(ValueAt(fitted.provenance, "log"));
  for (int i = 0; i < kNumParameters; ++i) {
    const FreeEntry entry = EntryOf(i, fitted.dof);
    SetValue(entry, values[i], &exported->model);
    exported->numbers.push_back({entry,
                                 values[i],
                                 std::sqrt(fitted.covariance(i, i)),
                                 true,
                                 ParameterUnit(i, fitted.dof, fitted.force_unit),
                                 log});
  }
  exported->model.dofs.push_back(fitted.dof);
  exported->sources.push_back(SourceLine(file, fitted.provenance));
  for (const std::string& caveat : fitted.caveats) {
    exported->caveats.push_back(fmt::format("{}: {}", Name(fitted.dof), caveat));
  }
  Eigen::Index first = kNumParameters;
  for (const ActiveEffect& active : fitted.effects) {
    exported->effects.push_back(EffectOf(active, fitted, first, log));
    first += static_cast<Eigen::Index>(active.values.size());
  }
}

}  // namespace

bool IsModelled(const ExportModel& model, Dof dof) {
  return std::find(model.model.dofs.begin(), model.model.dofs.end(), dof) != model.model.dofs.end();
}

ExportModel ExportModelOf(const FittedCoupledModel& fitted, const std::string& file) {
  ExportModel exported;
  exported.model = fitted.model;
  exported.force_unit = SharedUnit(fitted.force_unit);
  exported.sources = {SourceLine(file, fitted.provenance)};
  exported.caveats = fitted.caveats;
  const std::string log = ShortNameOf(ValueAt(fitted.provenance, "log"));
  for (const FreeEntry& entry : NumbersIn(fitted)) {
    ExportNumber number;
    number.entry = entry;
    number.value = ValueIn(fitted.model, entry);
    number.unit = UnitOf(entry, fitted.force_unit);
    number.log = log;
    number.is_identified = std::ranges::find(fitted.entries, entry) != fitted.entries.end();
    number.std = StdOf(fitted, entry);
    exported.numbers.push_back(std::move(number));
  }
  for (const auto& [run, current] : fitted.model.current) {
    exported.notes.push_back(fmt::format(
        "The current of {}, {:.3g} m/s north and {:.3g} m/s east, is of that run and left out.",
        run,
        current[0],
        current[1]));
  }
  for (const auto& [run, offset] : fitted.model.run_offset) {
    exported.notes.push_back(
        fmt::format("What {} adds to the offsets is of that run and left out.", run));
  }
  AddEffects(fitted, log, &exported);
  AddThrustInTime(fitted, log, &exported);
  return exported;
}

ExportModel ExportModelOf(const std::vector<FittedModel>& models,
                          const std::vector<std::string>& files) {
  ExportModel exported;
  exported.is_joined = true;
  exported.force_unit = SharedUnit(models.front().force_unit);
  // In the order of Dof, as a coupled model has them.
  std::array<const FittedModel*, 6> by_dof = {};
  std::array<std::string, 6> file_of;
  for (std::size_t k = 0; k < models.size(); ++k) {
    const auto dof = static_cast<std::size_t>(Index(models[k].dof));
    if (by_dof[dof] != nullptr) {
      throw InputError(fmt::format("{}: is a model of {}, as {} is: expected each DOF once.",
                                   files[k],
                                   Name(models[k].dof),
                                   file_of[dof]));
    }
    if (SharedUnit(models[k].force_unit) != exported.force_unit) {
      throw InputError(fmt::format("{}: takes commands in {}, {} in {}: expected one unit.",
                                   files[k],
                                   models[k].force_unit,
                                   files.front(),
                                   models.front().force_unit));
    }
    by_dof[dof] = &models[k];
    file_of[dof] = files[k];
  }
  for (std::size_t dof = 0; dof < 6; ++dof) {
    if (by_dof[dof] != nullptr) AddOneDof(*by_dof[dof], file_of[dof], &exported);
  }
  if (models.size() > 1) {
    exported.notes.push_back(
        "Each degree of freedom was identified alone: what couples them (Coriolis forces, inertia "
        "and damping off the diagonal) is not known and left out.");
  }
  return exported;
}

ExportModel ReadExportModel(const std::vector<std::filesystem::path>& paths) {
  std::vector<FittedModel> models;
  std::vector<std::string> files;
  for (const std::filesystem::path& path : paths) {
    const std::string text = ReadFile(path);
    if (IsCoupledModel(text)) {
      if (paths.size() > 1) {
        throw InputError(fmt::format(
            "{}: is a model of several DOFs: expected it alone, or models of one DOF each.",
            path.string()));
      }
      return ExportModelOf(ParseCoupledModel(path.string(), text), path.string());
    }
    models.push_back(ParseModel(path.string(), text));
    models.back().provenance = ProvenanceIn(path.string(), text);
    files.push_back(path.string());
  }
  return ExportModelOf(models, files);
}

}  // namespace fathom
