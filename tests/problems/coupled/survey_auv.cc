// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "survey_auv.h"

#include "fathom/coupled/structure_ladder.h"
#include "fathom/simulate/coupled/coupled_prediction.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "plain_simulator.h"

namespace fathom {
namespace {

constexpr double kMass = 30.0, kCentreOfMass = 0.02;       // [kg], below the origin [m]
constexpr double kSpeedNoise = 0.005, kTurnNoise = 0.003;  // [m/s], [rad/s] and [rad]

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double Between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double Normal() { return normal_(random_); }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

Fin FinAt(const char* name, double y, double z) {
  Fin fin;
  fin.name = name;
  fin.position << -0.8, y, z;
  fin.axis << 0.0, y, z;
  fin.axis.normalize();
  return fin;
}

// docs/fins.md (3) as the integral of its slope: 1, then down to 0 over a fifth of the limit.
double Stalled(double sine, double limit) {
  const double in_bend = std::clamp(std::abs(sine) - 0.9 * limit, 0.0, 0.2 * limit);
  const double size =
      std::min(std::abs(sine), 0.9 * limit) + in_bend * (1.0 - in_bend / (0.4 * limit));
  return std::copysign(size, sine);
}

// The law of docs/fins.md by angles and a turned normal; `limit`: the sine of the angle of attack
// at which the fin stalls.
Vector6 ForceByAngles(
    const Fin& fin, double f, double angle, std::optional<double> limit, const Vector6& nu) {
  const Eigen::Vector3d v = nu.head<3>() + Eigen::Vector3d(nu.tail<3>()).cross(fin.position);
  const Eigen::Vector3d across = fin.axis.cross(Eigen::Vector3d::UnitX());
  const double w = v.dot(across);
  double sine = std::sin(angle - std::atan2(w, v.x()));
  if (limit) sine = Stalled(sine, *limit);
  const double load = f * (v.x() * v.x() + w * w) * sine;
  const Eigen::Vector3d force = load * (Eigen::AngleAxisd(angle, fin.axis) * across);
  Vector6 all;
  all << force, fin.position.cross(force);
  return all;
}

// What is ordered of the stern: rudders, planes and a roll, held until `until`.
struct Orders {
  double thrust = 0.0, rudder = 0.0, plane = 0.0, roll = 0.0;
};

// A positive angle of each fin rolls the vehicle to the same side.
std::array<double, 4> AnglesOf(const Orders& orders) {
  return {orders.roll - orders.rudder,
          orders.roll + orders.rudder,
          orders.roll - orders.plane,
          orders.roll + orders.plane};
}

Orders OrdersAt(SurveyRun run, double t, Draw* draw) {
  if (run == SurveyRun::kSteps) {
    return {draw->Between(5.0, 16.0),
            draw->Between(-0.25, 0.25),
            draw->Between(-0.15, 0.15),
            draw->Between(-0.1, 0.1)};
  }
  const auto side = [&](double period) { return std::fmod(t, period) < 0.5 * period ? 1.0 : -1.0; };
  if (t < 60.0) return {12.0, 0.2 * side(10.0), 0.0, 0.0};
  if (t < 100.0) return {9.0, 0.25, 0.0, 0.0};
  return {12.0, 0.0, 0.12 * side(8.0), 0.0};
}

FreeEntry EntryOf(FinFault fault, const std::string& fin) {
  if (fault == FinFault::kDead) return FinForceEntry(fin);
  if (fault == FinFault::kSlow) return FinLagEntry(fin);
  if (fault == FinFault::kStalled) return FinStallEntry(fin);
  if (fault == FinFault::kLimited) return FinRateLimitEntry(fin);
  return fault == FinFault::kStuck ? FinStuckEntry(fin) : FinNeutralEntry(fin);
}

std::vector<StructureFin> StructureFinsOf(const SurveyAuv& auv) {
  std::vector<StructureFin> fins;
  for (const Fin& fin : auv.fins) fins.push_back({fin.name, true, false});
  return fins;
}

// The mean over DOFs of NMAE.
double MissOf(const CoupledModel& model, const CoupledData& log) {
  const auto prediction = PredictCoupled(model, {&log, 1}, 20.0);
  if (!prediction) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (const FitFigures& figures : prediction->figures) sum += figures.nmae;
  return sum / 6.0;
}

}  // namespace

SurveyAuv DrawnSurveyAuv(unsigned seed) {
  Draw draw(seed);
  const auto between = [&](double low, double high) { return draw.Between(low, high); };
  SurveyAuv auv;
  auv.fins = {FinAt("upper", 0.0, -0.12),
              FinAt("lower", 0.0, 0.12),
              FinAt("port", -0.12, 0.0),
              FinAt("starboard", 0.12, 0.0)};
  CoupledModel& model = auv.truth;
  model.dofs.assign(kAllDofs.begin(), kAllDofs.end());
  model.coriolis = true;
  model.inertia.diagonal() << between(31.0, 36.0), between(55.0, 75.0), between(55.0, 75.0),
      between(0.3, 0.6), between(7.0, 10.0), between(7.0, 10.0);
  model.inertia(0, 4) = model.inertia(4, 0) = kMass * kCentreOfMass;
  model.inertia(1, 3) = model.inertia(3, 1) = -kMass * kCentreOfMass;
  model.linear_damping.diagonal() << between(1.0, 3.0), between(8.0, 20.0), between(8.0, 20.0),
      between(0.3, 0.8), between(3.0, 6.0), between(3.0, 6.0);
  model.quadratic_damping.diagonal() << between(3.0, 6.0), between(100.0, 300.0),
      between(100.0, 300.0), between(0.2, 0.6), between(15.0, 40.0), between(15.0, 40.0);
  model.lift(1, 1) = between(10.0, 25.0);
  model.lift(1, 5) = between(-4.0, 4.0);
  model.lift(5, 1) = between(-12.0, -2.0);
  model.lift(5, 5) = between(3.0, 8.0);
  model.lift(2, 2) = between(10.0, 25.0);
  model.lift(2, 4) = between(-4.0, 4.0);
  model.lift(4, 2) = between(2.0, 12.0);
  model.lift(4, 4) = between(3.0, 8.0);
  model.quadratic_damping(1, 5) = between(-3.0, 3.0);
  model.quadratic_damping(5, 1) = between(-3.0, 3.0);
  model.quadratic_damping(2, 4) = between(-3.0, 3.0);
  model.quadratic_damping(4, 2) = between(-3.0, 3.0);
  model.righting_roll = between(4.0, 7.0);
  model.righting_pitch = between(5.0, 9.0);
  model.net_buoyancy = between(0.5, 3.0);
  model.offset << between(-0.3, 0.3), between(-0.3, 0.3), 0.0, between(-0.05, 0.05),
      between(-0.2, 0.2), between(-0.2, 0.2);
  const double force = between(7.0, 12.0);
  for (const Fin& fin : auv.fins) model.fin_force[fin.name] = force;
  auv.faulty = static_cast<std::size_t>(between(0.0, 4.0));
  const double degrees = between(3.0, 12.0) * (between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
  auv.stuck = degrees * std::numbers::pi / 180.0;
  return auv;
}

CoupledData SurveyLog(
    const SurveyAuv& auv, FinFault fault, SurveyRun run, double duration, unsigned seed) {
  const int num_steps = static_cast<int>(std::lround(10.0 * duration));
  Draw draw(1000 + seed);
  CoupledData data;
  data.log = "survey";
  data.dofs = auv.truth.dofs;
  data.force_unit = "N";
  data.has_velocity.fill(true);
  data.has_attitude = true;
  CoupledCommand& command = data.inputs.command;
  for (const Fin& fin : auv.fins) {
    command.fins.push_back({fin.name, ArmsOf(fin), {}, {}, auv.truth.fin_force.at(fin.name)});
  }
  PlainSimulator plain(auv.truth);
  plain.nu[0] = 1.0;
  std::array<double, 4> angles = {};
  double slow = 0.0, limited = 0.0;  // the angle of a slow fin, and of one of a limited rate
  plain.more = [&](const Vector6& nu) {
    Vector6 force = -nu[0] * (auv.truth.lift * nu);
    for (std::size_t k = 0; k < auv.fins.size(); ++k) {
      const Fin& fin = auv.fins[k];
      double angle = angles[k];
      if (k == auv.faulty && fault == FinFault::kDead) continue;
      if (k == auv.faulty && fault == FinFault::kStuck) angle = auv.stuck;
      if (k == auv.faulty && fault == FinFault::kSlow) angle = slow;
      if (k == auv.faulty && fault == FinFault::kLimited) angle = limited;
      if (k == auv.faulty && fault == FinFault::kNeutral) angle -= kNeutralOfSurvey;
      std::optional<double> limit;
      if (k == auv.faulty && fault == FinFault::kStalled) limit = std::sin(kStallOfSurvey);
      force += ForceByAngles(fin, auv.truth.fin_force.at(fin.name), angle, limit, nu);
    }
    return force;
  };
  CoupledSegment segment;
  Vector6 tau = Vector6::Zero();
  double next_change = 0.0;
  for (int k = 0; k <= num_steps; ++k) {
    const double t = 0.1 * k;
    Vector6 measured = plain.nu;
    Eigen::Vector3d turn;
    for (int i = 0; i < 6; ++i) measured[i] += (i < 3 ? kSpeedNoise : kTurnNoise) * draw.Normal();
    for (int i = 0; i < 3; ++i) turn[i] = kTurnNoise * draw.Normal();
    segment.time.push_back(t);
    segment.velocity.push_back(measured);
    segment.pose_time.push_back(t);
    segment.position.emplace_back(plain.position);
    segment.attitude.push_back(
        Eigen::Quaterniond(plain.world_from_body) *
        Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())));
    if (t >= next_change - 1e-9) {
      const Orders orders = OrdersAt(run, t, &draw);
      tau[0] = orders.thrust;
      angles = AnglesOf(orders);
      command.time.push_back(t);
      command.force.push_back(tau);
      for (std::size_t i = 0; i < angles.size(); ++i) command.fins[i].angle.push_back(angles[i]);
      next_change =
          run == SurveyRun::kSteps ? t + std::round(10.0 * draw.Between(1.0, 5.0)) / 10.0 : t + 1.0;
    }
    for (int step = 0; step < 20; ++step) {
      const double miss = angles[auv.faulty] - limited, most = 0.005 * kRateOfSurvey;
      slow += 0.005 / kLagOfSurvey * (angles[auv.faulty] - slow);
      limited += std::clamp(miss, -most, most);
      plain.Advance(tau, 0.005, 0.005);
    }
  }
  data.segments.push_back(segment);
  return data;
}

EntrySearchOptions SearchOptionsOf(const SurveyAuv& auv) {
  EntrySearchOptions options;
  options.fit.held.fin_force = auv.truth.fin_force;
  options.fit.held.inertia = auv.truth.inertia;
  options.fit.held.inertia.diagonal().setZero();
  options.fins = StructureFinsOf(auv);
  return options;
}

SurveyFit FitSurvey(unsigned seed) {
  const SurveyAuv auv = DrawnSurveyAuv(seed);
  CoupledLogs logs;
  logs.data = {SurveyLog(auv, FinFault::kNone, SurveyRun::kSteps, 150.0, seed)};
  const CoupledSummary fit =
      FitBlocks(logs,
                StructureOf(StandardStructure::kLift, auv.truth.dofs, StructureFinsOf(auv)),
                SearchOptionsOf(auv).fit);
  SurveyFit result;
  result.is_usable = fit.IsUsable();
  result.message = fit.message;
  if (!result.is_usable) return result;
  for (const FreeEntry& entry : fit.entries) {
    const double error = ValueIn(fit.model, entry) - ValueIn(auv.truth, entry);
    ++result.num_numbers;
    if (std::abs(error) < 1.96 * StdOf(fit, entry)) ++result.num_covered;
  }
  const CoupledData unseen =
      SurveyLog(auv, FinFault::kNone, SurveyRun::kManoeuvres, 150.0, seed + 500);
  result.miss_ratio = MissOf(fit.model, unseen) / MissOf(auv.truth, unseen);
  return result;
}

SurveyNaming NameFault(unsigned seed, FinFault fault) {
  const SurveyAuv auv = DrawnSurveyAuv(seed);
  CoupledLogs logs;
  logs.data = {SurveyLog(auv, fault, SurveyRun::kSteps, 50.0, seed)};
  const Ladder ladder = ClimbLadder(logs, auv.truth.dofs, SearchOptionsOf(auv));
  SurveyNaming result;
  for (const NamedEntry& named : ladder.named) {
    const bool is_fault =
        fault != FinFault::kNone && named.entry == EntryOf(fault, auv.fins[auv.faulty].name);
    if (is_fault) {
      result.is_right = true;
      result.value = named.value;
      result.std = named.std;
    } else {
      ++result.num_false;
    }
    result.named.push_back(NameOf(named.entry));
    for (const FreeEntry& other : named.not_told_apart) {
      result.not_told_apart.push_back(NameOf(other));
    }
  }
  return result;
}

}  // namespace fathom
