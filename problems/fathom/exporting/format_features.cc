// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/format_features.h"

#include "fathom/base/input_error.h"
#include "fathom/base/names_of_dofs.h"
#include "fathom/vehicle/coupled/coupled_effects.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

using How = HeldFeature::How;

constexpr HeldFeature kHeld = {};
constexpr HeldFeature kRefused = {How::kRefused, "refused"};
constexpr HeldFeature kNotedUnit = {How::kNote, "a note"};
constexpr HeldFeature kBodyAlone = {How::kNote, "the body alone, without damping"};
constexpr HeldFeature kKept = {How::kYes, "keep their velocity"};

constexpr HeldFeature LeftOut(const char* instead) { return {How::kLeftOut, "left out", instead}; }
constexpr HeldFeature Shown(const char* shown) { return {How::kYes, shown}; }
constexpr HeldFeature Noted(const char* shown) { return {How::kNote, shown}; }

constexpr HeldFeature kNoForce =
    LeftOut("no element holds a constant force. Subtract it from the thrust.");
constexpr HeldFeature kNoGain =
    LeftOut("multiply the thrust coefficient of that thruster's plugin by it.");
constexpr HeldFeature kTurnIt =
    LeftOut("turn the wrench about z by it first, X' = X cos a - Y sin a, Y' = X sin a + Y cos a.");
constexpr HeldFeature kNoEffect = LeftOut("the model without it is exported.");
constexpr HeldFeature kOnlyLag = LeftOut("the plugin's thrusters have a FirstOrder lag alone.");
constexpr HeldFeature kDiagonal = LeftOut("the plugin takes the diagonal alone.");
constexpr HeldFeature kOneAnAxis = LeftOut("Stonefish has one coefficient an axis.");

struct FeatureRow {
  const char* name;
  std::array<HeldFeature, 7> in_format;  // in the order of ExportFormat
};

// In the order of ExportFeature. Formats: c, csv, gazebo, mss, stonefish, uuv, vrx.
constexpr std::array<FeatureRow, 25> kFeatureRows = {{
    {"inertia",
     {kHeld,
      kHeld,
      Shown("less the rigid body, as `<fluid_added_mass>`"),
      kHeld,
      Noted("the body; added mass is made from the shape"),
      Shown("less the rigid body, positive, FRD"),
      Shown("less the rigid body, positive")}},
    {"inertia off the diagonal",
     {kHeld, kHeld, kHeld, kHeld, LeftOut("added mass is made from the shape."), kHeld, kDiagonal}},
    {"C(nu)",
     {Shown("as in the model"),
      Shown("said in the head"),
      Noted("always, by the physics engine"),
      Shown("as in the model"),
      Noted("of the body alone"),
      Noted("always, by the plugin"),
      Noted("of the body; of the added mass from jazzy on")}},
    {"linear damping along the axes",
     {kHeld,
      kHeld,
      Shown("below 0"),
      kHeld,
      Shown("at least 0, `viscous_drag`"),
      Shown("below 0"),
      Shown("above 0")}},
    {"quadratic damping along the axes",
     {kHeld,
      kHeld,
      Shown("below 0"),
      kHeld,
      Shown("at least 0, matched at --speed"),
      Shown("below 0"),
      Shown("above 0")}},
    {"damping of roll, pitch, yaw",
     {kHeld,
      kHeld,
      Shown("below 0"),
      kHeld,
      LeftOut("Stonefish makes the drag of turning from that along the axes and the shape."),
      Shown("below 0"),
      Shown("above 0")}},
    {"linear damping off the diagonal", {kHeld, kHeld, kHeld, kHeld, kOneAnAxis, kHeld, kDiagonal}},
    {"quadratic damping off the diagonal",
     {kHeld, kHeld, kHeld, kHeld, kOneAnAxis, kDiagonal, kDiagonal}},
    {"forces that grow with the speed ahead (lift)",
     {kHeld, kHeld, kRefused, kHeld, kRefused, kRefused, kRefused}},
    {"net buoyancy",
     {kHeld,
      kHeld,
      Noted("a note: the volume of a collision"),
      kHeld,
      Shown("by the size of the box"),
      Shown("`<volume>`"),
      LeftOut("the hull of vrx::Surface floats the boat.")}},
    {"righting moments",
     {kHeld,
      kHeld,
      Noted("a note: that collision's centre"),
      kHeld,
      Shown("by the place of the box"),
      Shown("`<center_of_buoyancy>`"),
      LeftOut("the hull of vrx::Surface rights the boat.")}},
    {"offset of roll, pitch",
     {kHeld,
      kHeld,
      Noted("a note: that collision's centre"),
      kHeld,
      Shown("by the place of the box"),
      Shown("`<center_of_buoyancy>`"),
      kNoForce}},
    {"offset of the others", {kHeld, kHeld, kNoForce, kHeld, kNoForce, kNoForce, kNoForce}},
    {"gains of thrusters",
     {Shown("with --vehicle"),
      kHeld,
      kNoGain,
      LeftOut("multiply its thrust by it before tau is summed."),
      kNoGain,
      kNoGain,
      kNoGain}},
    {"fins", {Shown("with --vehicle"), kHeld, kRefused, kRefused, kRefused, kRefused, kRefused}},
    {"angle of the thrust", {kTurnIt, kHeld, kTurnIt, kTurnIt, kTurnIt, kTurnIt, kTurnIt}},
    {"lag of thrusters",
     {kHeld,
      kHeld,
      kNoEffect,
      kNoEffect,
      LeftOut("rotor_dynamics of type first_order takes it, but of the rotor's speed."),
      LeftOut("<dynamics> of type FirstOrder takes its <timeConstant>, exactly where <conversion> "
              "is linear."),
      kNoEffect}},
    {"dead zone, saturation, asymmetry of the thrust along a DOF",
     {kHeld, kHeld, kNoEffect, kNoEffect, kNoEffect, kOnlyLag, kNoEffect}},
    {"dead zone, asymmetry of each thruster",
     {LeftOut("take it off each thruster's thrust before tau is summed."),
      kHeld,
      kNoEffect,
      kNoEffect,
      kNoEffect,
      kOnlyLag,
      kNoEffect}},
    {"friction, cubic damping, damping that differs astern",
     {kHeld, kHeld, kNoEffect, kNoEffect, kNoEffect, kOnlyLag, kNoEffect}},
    {"delay of the command (time_offset)",
     {Noted("a number: give the command so late"),
      kHeld,
      kNoEffect,
      kNoEffect,
      kNoEffect,
      kOnlyLag,
      kNoEffect}},
    {"other effects (a current, a sensor's lag)",
     {kNoEffect, kHeld, kNoEffect, kNoEffect, kNoEffect, kOnlyLag, kNoEffect}},
    {"commands in another unit than N",
     {kNotedUnit, kHeld, kRefused, kNotedUnit, kRefused, kRefused, kRefused}},
    {"DOFs that are not modelled",
     {kKept, Shown("no line"), kBodyAlone, kKept, kBodyAlone, kBodyAlone, kBodyAlone}},
    {"needs of --vehicle",
     {Shown("nothing"),
      Shown("nothing"),
      Shown("mass, `rigid_body`"),
      Shown("nothing"),
      Shown("mass, `rigid_body`, size"),
      Shown("mass, `rigid_body`"),
      Shown("mass, `rigid_body`")}},
}};

// Whether the vehicle file has a thruster or a shaft of that name.
bool HasThruster(const ExportTarget& target, const std::string& name) {
  if (!target.vehicle) return false;
  const std::vector<Thruster>& thrusters = target.vehicle->thrusters;
  const std::vector<Shaft>& shafts = target.vehicle->shafts;
  return std::ranges::find(thrusters, name, &Thruster::name) != thrusters.end() ||
         std::ranges::find(shafts, name, &Shaft::name) != shafts.end();
}

// "c, csv, mss".
std::string FormatsThatHold(ExportFeature feature) {
  std::vector<std::string_view> names;
  for (const ExportFormat format : kExportFormats) {
    if (Held(format, feature).how != How::kRefused) names.push_back(Name(format));
  }
  return fmt::to_string(fmt::join(names, ", "));
}

// "kg" behind a space, or nothing of a ratio.
std::string UnitBehind(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

void AddNumberRemarks(ExportFormat format,
                      const ExportModel& model,
                      const ExportTarget& target,
                      std::vector<std::string>* remarks) {
  for (const ExportNumber& number : model.numbers) {
    const ExportFeature feature = FeatureOf(number.entry);
    HeldFeature held = Held(format, feature);
    if (held.how == How::kRefused) {
      throw InputError(
          fmt::format("--model: has {}, which --format={} does not hold; expected one of {}.",
                      NameOf(number.entry),
                      Name(format),
                      FormatsThatHold(feature)));
    }
    if (format == ExportFormat::kC && number.entry.kind == FreeEntry::Kind::kThrustGain &&
        !HasThruster(target, number.entry.actuator)) {
      held = LeftOut(
          "multiply its thrust by it before tau is summed, or give the vehicle file that has that "
          "thruster.");
    }
    if (held.how != How::kLeftOut || number.value == 0.0) continue;
    remarks->push_back(fmt::format("{} of {:.4g}{} is left out: {}",
                                   NameOf(number.entry),
                                   number.value,
                                   UnitBehind(number.unit),
                                   held.instead));
  }
}

void AddEffectRemarks(ExportFormat format,
                      const ExportModel& model,
                      std::vector<std::string>* remarks) {
  for (const ExportEffect& effect : model.effects) {
    const HeldFeature held = Held(format, FeatureOf(effect));
    if (held.how == How::kNote) {
      remarks->push_back(
          fmt::format("Give the command of {} {:.4g} s late (below 0: early): the effect {}.",
                      Name(effect.dof),
                      effect.values.front().value,
                      effect.label));
    }
    if (held.how != How::kLeftOut) continue;
    std::vector<std::string> values;
    for (const ExportEffectValue& value : effect.values) {
      values.push_back(fmt::format("{} {:.6g} {}", value.name, value.value, value.unit));
    }
    remarks->push_back(fmt::format(
        "The effect {} of {} is left out ({}): {}",
        effect.label,
        Name(effect.dof),
        values.empty() ? "it has no parameters" : fmt::to_string(fmt::join(values, ", ")),
        held.instead));
  }
}

// Of formats that hold a body of six DOFs.
void AddBodyRemarks(const ExportModel& model, std::vector<std::string>* remarks) {
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind != FreeEntry::Kind::kInertia || IsModelled(model, number.entry.column))
      continue;
    remarks->push_back(fmt::format("{} of {:.4g} {} is left out: {} is not modelled.",
                                   NameOf(number.entry),
                                   number.value,
                                   number.unit,
                                   Name(number.entry.column)));
  }
  std::vector<Dof> others;
  for (const Dof dof : kAllDofs) {
    if (!IsModelled(model, dof)) others.push_back(dof);
  }
  if (!others.empty()) {
    remarks->push_back(
        fmt::format("Not modelled: {}. Their added mass and damping are not known and stand as 0.",
                    NamesOf(others)));
  }
}

void AddCoriolisRemark(ExportFormat format,
                       const ExportModel& model,
                       std::vector<std::string>* remarks) {
  if (Held(format, ExportFeature::kCoriolis).how != How::kNote) return;
  if (!model.model.coriolis) {
    remarks->push_back(
        fmt::format("The model has no Coriolis forces, but {} adds those of the inertia. They act "
                    "where several degrees of freedom move at once.",
                    format == ExportFormat::kGazebo ? "Gazebo" : "the simulator"));
  } else if (format == ExportFormat::kVrx) {
    remarks->push_back(
        "VRX before jazzy computes the Coriolis forces of the added mass, and does not use them.");
  } else if (format == ExportFormat::kStonefish) {
    remarks->push_back("The Coriolis forces of the added mass are left out: Stonefish has none.");
  }
}

}  // namespace

ExportFeature FeatureOf(const FreeEntry& entry) {
  const bool is_diagonal = entry.row == entry.column;
  switch (entry.kind) {
    case FreeEntry::Kind::kInertia:
      return is_diagonal ? ExportFeature::kInertia : ExportFeature::kInertiaCouplings;
    case FreeEntry::Kind::kLinearDamping:
      if (!is_diagonal) return ExportFeature::kLinearCouplings;
      return IsAngular(entry.row) ? ExportFeature::kDampingOfTurns : ExportFeature::kLinearDamping;
    case FreeEntry::Kind::kQuadraticDamping:
      if (!is_diagonal) return ExportFeature::kQuadraticCouplings;
      return IsAngular(entry.row) ? ExportFeature::kDampingOfTurns
                                  : ExportFeature::kQuadraticDamping;
    case FreeEntry::Kind::kRightingMoment:
      return ExportFeature::kRightingMoment;
    case FreeEntry::Kind::kNetBuoyancy:
      return ExportFeature::kNetBuoyancy;
    case FreeEntry::Kind::kOffset:
      return entry.row == Dof::kRoll || entry.row == Dof::kPitch ? ExportFeature::kTrim
                                                                 : ExportFeature::kOffset;
    case FreeEntry::Kind::kThrustAngle:
      return ExportFeature::kThrustAngle;
    case FreeEntry::Kind::kTimeOffset:
      return ExportFeature::kDelay;
    case FreeEntry::Kind::kThrusterLag:
      return ExportFeature::kLag;
    case FreeEntry::Kind::kThrustGain:
      return ExportFeature::kThrustGain;
    case FreeEntry::Kind::kLift:
      return ExportFeature::kLift;
    case FreeEntry::Kind::kFinForce:
    case FreeEntry::Kind::kFinRace:
    case FreeEntry::Kind::kFinNeutral:
    case FreeEntry::Kind::kFinStuck:
    case FreeEntry::Kind::kFinLag:
    case FreeEntry::Kind::kFinRateLimit:
    case FreeEntry::Kind::kFinStall:
      return ExportFeature::kFins;
    case FreeEntry::Kind::kEffect:  // ExportModel::effects
    case FreeEntry::Kind::kThrusterEffect:
      return ExportFeature::kThrusterEffect;
    case FreeEntry::Kind::kCurrent:  // of a run, in no export
    case FreeEntry::Kind::kRunOffset:
      break;
  }
  return ExportFeature::kThrustGain;
}

ExportFeature FeatureOf(const ExportEffect& effect) {
  if (effect.name == "thruster_lag") return ExportFeature::kLag;
  if (effect.name == "time_offset") return ExportFeature::kDelay;
  for (const char* name : {"thrust_dead_zone", "thrust_saturation", "thrust_asymmetry"}) {
    if (effect.name == name) return ExportFeature::kThrustSize;
  }
  for (const Effect* drag : WaterEffects()) {
    if (effect.name == drag->info().name) return ExportFeature::kDragEffects;
  }
  return ExportFeature::kOtherEffects;
}

HeldFeature Held(ExportFormat format, ExportFeature feature) {
  return kFeatureRows[static_cast<std::size_t>(feature)]
      .in_format[static_cast<std::size_t>(format)];
}

std::string FeatureTable() {
  std::string head = "| of the model |", line = "| --- |", rows;
  for (const ExportFormat format : kExportFormats) {
    head += fmt::format(" `{}` |", Name(format));
    line += " --- |";
  }
  for (const FeatureRow& row : kFeatureRows) {
    rows += fmt::format("| {} |", row.name);
    for (const HeldFeature& held : row.in_format) rows += fmt::format(" {} |", held.shown);
    rows += "\n";
  }
  return head + "\n" + line + "\n" + rows;
}

std::vector<std::string> RemarksOn(ExportFormat format,
                                   const ExportModel& model,
                                   const ExportTarget& target) {
  std::vector<std::string> remarks = model.notes;
  const How unit = Held(format, ExportFeature::kOtherUnit).how;
  if (model.force_unit != "N" && unit == How::kRefused) {
    throw InputError(
        fmt::format("--model: takes commands in {}, so that its inertia is not in kg. "
                    "Expected newtons for --format={}.",
                    model.force_unit,
                    Name(format)));
  }
  if (model.force_unit != "N" && unit == How::kNote) {
    remarks.push_back(fmt::format(
        "Commands are in {}, not in newtons: give tau in that unit. Only ratios of the numbers "
        "have a meaning.",
        model.force_unit));
  }
  AddNumberRemarks(format, model, target, &remarks);
  AddEffectRemarks(format, model, &remarks);
  AddCoriolisRemark(format, model, &remarks);
  if (Held(format, ExportFeature::kOtherDofs).how == How::kNote) AddBodyRemarks(model, &remarks);
  return remarks;
}

}  // namespace fathom
