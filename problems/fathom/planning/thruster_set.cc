// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_set.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kRounding = 1e-12;  // of a thrust, beyond its range

// That all tables hold.
double VoltageOf(double given, const Vehicle& vehicle, const std::string& name) {
  for (const Thruster& thruster : vehicle.thrusters) {
    const ThrustTable* table = TableOf(thruster, vehicle);
    if (table == nullptr) continue;
    const std::vector<double>& voltages = table->voltages;
    if (std::isnan(given) && voltages.size() == 1) given = voltages.front();
    if (std::isnan(given)) {
      throw InputError(fmt::format(
          "--voltage: is missing, expected the volts of the supply, since table '{}' of "
          "{} holds {:g} V.",
          table->name,
          name,
          fmt::join(voltages, ", ")));
    }
    if (given >= voltages.front() && given <= voltages.back()) continue;
    throw InputError(
        fmt::format("--voltage: is {:g} V, expected {:g} to {:g} V as in table '{}' of {}.",
                    given,
                    voltages.front(),
                    voltages.back(),
                    table->name,
                    name));
  }
  return given;
}

ValueRange RangeOfThruster(const Thruster& thruster,
                           const ThrustTable* table,
                           const ThrusterSupply& supply,
                           double voltage) {
  ValueRange range = {-supply.thruster_force, supply.thruster_force};
  const auto narrow = [&](double low, double high) {
    range = {std::max(range.low, low), std::min(range.high, high)};
  };
  if (table != nullptr) {
    std::vector<double> thrusts;
    for (const double command : table->commands) thrusts.push_back(table->Thrust(command, voltage));
    const auto [low, high] = std::minmax_element(thrusts.begin(), thrusts.end());
    narrow(std::min(0.0, *low), std::max(0.0, *high));
  } else if (thruster.forward_coefficient > 0.0 && thruster.reverse_coefficient == 0.0) {
    narrow(0.0, PlanLimits::kNoLimit);
  }
  return range;
}

bool IsWithin(double thrust, const ValueRange& range) {
  const double slack = kRounding * std::abs(thrust);
  return thrust >= range.low - slack && thrust <= range.high + slack;
}

}  // namespace

bool ThrusterSet::Gives(const std::vector<double>& thrusts) const {
  for (std::size_t k = 0; k < thrusts.size(); ++k) {
    if (!IsWithin(thrusts[k], range[k])) return false;
  }
  return true;
}

std::vector<double> ThrusterSet::WithoutRounding(std::vector<double> thrusts) const {
  for (std::size_t k = 0; k < thrusts.size(); ++k) {
    if (IsWithin(thrusts[k], range[k])) {
      thrusts[k] = std::clamp(thrusts[k], range[k].low, range[k].high);
    }
    thrusts[k] += 0.0;  // -0 would be printed as such
  }
  return thrusts;
}

bool ThrusterSet::HasPulses() const {
  return !table.empty() && std::all_of(table.begin(), table.end(), [](const ThrustTable* one) {
    return one != nullptr && one->command_unit == "us";
  });
}

std::vector<int> ThrusterSet::PulsesOf(const std::vector<double>& thrusts) const {
  std::vector<int> pulses;
  if (!HasPulses()) return pulses;
  for (std::size_t k = 0; k < thrusts.size(); ++k) {
    pulses.push_back(static_cast<int>(std::lround(*table[k]->CommandFor(thrusts[k], voltage))));
  }
  return pulses;
}

ThrusterSet ThrustersOf(const ThrusterSupply& supply,
                        const Vehicle& vehicle,
                        const std::string& name) {
  if (vehicle.thrusters.empty()) {
    throw InputError(fmt::format("{}: has no thrusters, expected some to be commanded.", name));
  }
  ThrusterSet set;
  set.voltage = VoltageOf(supply.voltage, vehicle, name);
  for (const Thruster& thruster : vehicle.thrusters) {
    const ThrustTable* table = TableOf(thruster, vehicle);
    set.names.push_back(thruster.name);
    set.table.push_back(table);
    set.range.push_back(RangeOfThruster(thruster, table, supply, set.voltage));
    if (table == nullptr || table->CommandFor(0.0, set.voltage)) continue;
    throw InputError(fmt::format(
        "{}: table '{}' gives no command for a thrust of 0 N at {:g} V, expected thrust "
        "that passes 0 and rises from command to command, or falls.",
        name,
        table->name,
        set.voltage));
  }
  return set;
}

}  // namespace fathom
