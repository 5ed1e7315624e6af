// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/coupled_yaml.h"

#include "fathom/base/dof.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

std::vector<Dof> ModelledDofs(const YamlMap& map) {
  std::vector<Dof> dofs;
  if (!map.Has("dofs")) return {kAllDofs.begin(), kAllDofs.end()};
  for (const std::string& name : map.Strings("dofs")) {
    const auto dof = DofFromName(name);
    if (!dof) {
      map.Fail(
          "dofs",
          fmt::format("holds {}, expected surge, sway, heave, roll, pitch or yaw.", Quoted(name)));
    }
    if (std::find(dofs.begin(), dofs.end(), *dof) != dofs.end()) {
      map.Fail("dofs", fmt::format("holds {} twice, expected each once.", Quoted(name)));
    }
    dofs.push_back(*dof);
  }
  if (dofs.empty()) map.Fail("dofs", "is empty, expected at least one DOF.");
  std::sort(dofs.begin(), dofs.end());
  return dofs;
}

// Six rows of six numbers, or the six on the diagonal.
Matrix6 SixBySix(const YamlMap& map, std::string_view key) {
  const std::vector<std::vector<double>> rows = map.NumberLists(key, 6);
  Matrix6 matrix = Matrix6::Zero();
  if (rows.size() == 1) {
    for (int i = 0; i < 6; ++i) matrix(i, i) = rows[0][static_cast<std::size_t>(i)];
    return matrix;
  }
  if (rows.size() != 6) {
    map.Fail(key,
             fmt::format("has {} rows, expected 6 of 6 numbers each, or the 6 on the diagonal.",
                         rows.size()));
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
  }
  return matrix;
}

Matrix6 SixBySixIfThere(const YamlMap& map, std::string_view key) {
  return map.Has(key) ? SixBySix(map, key) : Matrix6(Matrix6::Zero());
}

Matrix6 SymmetricSixBySix(const YamlMap& map, std::string_view key) {
  const Matrix6 matrix = SixBySix(map, key);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < i; ++j) {
      if (matrix(i, j) == matrix(j, i)) continue;
      map.Fail(key,
               fmt::format("is {} in row {}, column {}, but {} in row {}, column {}, expected a "
                           "symmetric matrix.",
                           matrix(i, j),
                           i + 1,
                           j + 1,
                           matrix(j, i),
                           j + 1,
                           i + 1));
    }
  }
  return matrix;
}

// Mass plus added mass, given as it is or as what the water adds to the rigid body.
Matrix6 ReadInertia(const YamlMap& map, const RigidBody& body, const std::vector<Dof>& dofs) {
  const bool is_added = map.Has("added_mass");
  if (!is_added && !map.Has("inertia")) {
    map.Fail("holds neither 'inertia' nor 'added_mass', expected one of them.");
  }
  if (is_added && map.Has("inertia")) {
    map.Fail("added_mass", "stands beside 'inertia', which holds it already. Remove one of them.");
  }
  const std::string_view key = is_added ? "added_mass" : "inertia";
  Matrix6 inertia = SymmetricSixBySix(map, key);
  if (is_added) {
    const auto rigid = RigidInertia(body);
    if (!rigid) {
      map.Fail(key,
               "needs the body that it is added to, expected `mass` and, in `rigid_body`, "
               "`inertia_tensor` and `centre_of_mass`.");
    }
    inertia += *rigid;
  }
  if (!IsPositiveDefinite(inertia, dofs)) {
    map.Fail(key,
             "gives an inertia that is not positive definite in the modelled DOFs: some motion "
             "would have no energy. Expected mass plus added mass, in kg, kg m and kg m^2.");
  }
  return inertia;
}

// Numbers by the name of a thruster or a fin.
template <typename Actuator>
std::map<std::string, double> ByName(const YamlMap& map,
                                     std::string_view key,
                                     const std::vector<Actuator>& actuators,
                                     std::string_view kind) {
  std::map<std::string, double> numbers;
  const auto named = map.OptionalMap(key);
  if (!named) return numbers;
  for (const std::string& name : named->Keys()) {
    const bool is_known = std::any_of(
        actuators.begin(), actuators.end(), [&](const Actuator& a) { return a.name == name; });
    if (!is_known) {
      named->Has(name);
      named->Fail(name, fmt::format("is no {} of this file, expected the name of one.", kind));
    }
    numbers[name] = named->Number(name);
  }
  return numbers;
}

void RequirePassive(const YamlMap& map, const CoupledModel& model) {
  if (IsPassive(model)) return;
  for (const Dof dof : model.dofs) {
    const double quadratic = model.quadratic_damping(Index(dof), Index(dof));
    if (quadratic >= 0.0) continue;
    map.Fail("quadratic_damping",
             fmt::format("is {} along {}, expected at least 0: damping stands on the left of the "
                         "equation and takes energy.",
                         quadratic,
                         Name(dof)));
  }
  map.Fail("linear_damping",
           "gives energy at some velocity, expected a matrix whose symmetric part is positive "
           "semidefinite: damping stands on the left of the equation.");
}

void RequireLags(const YamlMap& map, const CoupledModel& model) {
  constexpr const char* kExpected = "is below 0 s, expected a time constant.";
  if (model.thruster_lag < 0.0) map.Fail("thruster_lag", kExpected);
  for (const auto& [fin, lag] : model.fin_lag) {
    if (lag < 0.0) map.Fail("fin_lag", fmt::format("of {} {}", fin, kExpected));
  }
}

void RequireLimits(const YamlMap& map, const CoupledModel& model) {
  for (const auto& [fin, rate] : model.fin_rate_limit) {
    if (MayBe(FinRateLimitEntry(fin), rate)) continue;
    map.Fail("fin_rate_limit",
             fmt::format("of {} is {} rad/s, expected a rate above 0 rad/s.", fin, rate));
  }
  for (const auto& [fin, angle] : model.fin_stall) {
    if (MayBe(FinStallEntry(fin), angle)) continue;
    map.Fail("fin_stall",
             fmt::format("of {} is {} rad, expected an angle of attack above 0 and below pi/2 rad.",
                         fin,
                         angle));
  }
  if (const auto fin = FinWithLagAndRateLimit(model)) {
    map.Fail("fin_rate_limit",
             fmt::format("of {} stands beside its 'fin_lag', expected one of them.", *fin));
  }
}

// The matrices are those of the body, six by six whatever of it is modelled. A number by itself
// that no modelled DOF feels is a mistake.
void RequireModelled(const YamlMap& map, const CoupledModel& model) {
  const auto is_modelled = [&](Dof dof) {
    return std::find(model.dofs.begin(), model.dofs.end(), dof) != model.dofs.end();
  };
  constexpr const char* kExpected = "is none of 'dofs', so that it has no effect. Expected 0.";
  for (const Dof dof : kAllDofs) {
    if (model.offset[Index(dof)] == 0.0 || is_modelled(dof)) continue;
    map.Fail(
        "offset",
        fmt::format("is {} along {}, which {}", model.offset[Index(dof)], Name(dof), kExpected));
  }
  for (const auto& [dof, moment] :
       {std::pair(Dof::kRoll, model.righting_roll), std::pair(Dof::kPitch, model.righting_pitch)}) {
    if (moment == 0.0 || is_modelled(dof)) continue;
    map.Fail("righting_moment", fmt::format("is {} of {}, which {}", moment, Name(dof), kExpected));
  }
  // Of a tilted vehicle it acts along the other axes too.
  const bool feels_buoyancy =
      is_modelled(Dof::kHeave) || is_modelled(Dof::kRoll) || is_modelled(Dof::kPitch);
  if (model.net_buoyancy != 0.0 && !feels_buoyancy) {
    map.Fail(
        "net_buoyancy",
        fmt::format("is {}, but none of heave, roll and pitch is one of 'dofs', so that it has "
                    "no effect. Expected 0.",
                    model.net_buoyancy));
  }
}

// Those of the vehicle file's area and lift slope, unless the model says otherwise.
std::map<std::string, double> FinForces(const YamlMap& map, const std::vector<Fin>& fins) {
  std::map<std::string, double> forces = ByName(map, "fin_force", fins, "fin");
  for (const Fin& fin : fins) {
    if (const auto force = FinForceOf(fin)) forces.try_emplace(fin.name, *force);
  }
  return forces;
}

// Numbers of effects by the names of their entries: "coulomb_friction.surge: 2".
void ReadEffects(const YamlMap& map, CoupledModel* model) {
  const auto named = map.OptionalMap("effects");
  if (!named) return;
  for (const std::string& name : named->Keys()) {
    const double value = named->Number(name);
    FreeEntry entry;
    try {
      entry = ParseFreeEntry(name);
    } catch (const InputError&) {
      // Refused below.
    }
    if (!IsEffect(entry)) {
      named->Fail(name, "is no effect of a coupled model, expected one of docs/coupled.md.");
    }
    if (!MayBe(entry, value)) {
      const EffectParameter& parameter = entry.effect->info().parameters.front();
      named->Fail(
          name, fmt::format("is {}, expected {} to {}.", value, parameter.lower, parameter.upper));
    }
    const bool is_modelled =
        IsOfActuator(entry) ||
        std::find(model->dofs.begin(), model->dofs.end(), entry.row) != model->dofs.end();
    if (value != 0.0 && !is_modelled) {
      named->Fail(name, "acts along none of 'dofs', so that it has no effect. Expected 0.");
    }
    SetValue(entry, value, model);
  }
}

}  // namespace

CoupledModel ReadCoupledYaml(const YamlMap& map,
                             const RigidBody& body,
                             const std::vector<Thruster>& thrusters,
                             const std::vector<Fin>& fins,
                             const std::vector<Shaft>& shafts) {
  CoupledModel model;
  model.dofs = ModelledDofs(map);
  model.coriolis = map.Boolean("coriolis", true);
  model.inertia = ReadInertia(map, body, model.dofs);
  model.linear_damping = SixBySixIfThere(map, "linear_damping");
  model.quadratic_damping = SixBySixIfThere(map, "quadratic_damping");
  model.lift = SixBySixIfThere(map, "lift");
  RequirePassive(map, model);
  if (map.Has("offset")) {
    const std::vector<double> offset = map.Numbers("offset", 6);
    model.offset = Eigen::Map<const Vector6>(offset.data());
  }
  model.net_buoyancy = map.Number("net_buoyancy", 0.0);
  model.thrust_angle = map.Number("thrust_angle", 0.0);
  model.time_offset = map.Number("time_offset", 0.0);
  model.thruster_lag = map.Number("thruster_lag", 0.0);
  if (const auto righting = map.OptionalMap("righting_moment")) {
    model.righting_roll = righting->Number("roll", 0.0);
    model.righting_pitch = righting->Number("pitch", 0.0);
  }
  // A shaft's gain stands beside those of thrusters.
  std::vector<Shaft> thrusting = shafts;
  for (const Thruster& thruster : thrusters) thrusting.emplace_back().name = thruster.name;
  model.thrust_gain = ByName(map, "thrust_gain", thrusting, "thruster or shaft");
  model.fin_force = FinForces(map, fins);
  model.fin_race = ByName(map, "fin_race", fins, "fin");
  model.fin_neutral = ByName(map, "fin_neutral", fins, "fin");
  model.fin_stuck = ByName(map, "fin_stuck", fins, "fin");
  model.fin_lag = ByName(map, "fin_lag", fins, "fin");
  model.fin_rate_limit = ByName(map, "fin_rate_limit", fins, "fin");
  model.fin_stall = ByName(map, "fin_stall", fins, "fin");
  RequireLags(map, model);
  RequireLimits(map, model);
  ReadEffects(map, &model);
  RequireModelled(map, model);
  return model;
}

}  // namespace fathom
