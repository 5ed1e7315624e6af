// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/name_causes.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "drawn_archive.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> DiveNames(int num_dives) {
  std::vector<std::string> names;
  for (int dive = 0; dive < num_dives; ++dive) names.push_back(std::to_string(dive));
  return names;
}

// Two along surge, 0.3 m to either side, and one along heave.
Vehicle ThreeThrusters() {
  Vehicle vehicle;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  vehicle.thrusters = {{"port", {0.0, -0.3, 0.0}, x, 0.1, 0.1},
                       {"starboard", {0.0, 0.3, 0.0}, x, 0.1, 0.1},
                       {"vertical", {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), 0.1, 0.1}};
  return vehicle;
}

using Effect = std::function<void(DiveEstimate*)>;

std::vector<ChangeEvent> EventsOf(const DrawnArchive& archive,
                                  const Effect& effect,
                                  const std::optional<Vehicle>& vehicle,
                                  std::uint64_t seed = 1) {
  RandomStream random(seed, "archive");
  std::vector<DiveEstimate> estimates = DrawQuiet(archive, &random);
  for (DiveEstimate& estimate : estimates) effect(&estimate);
  const ChangeOptions options;
  const std::vector<std::string> names = DiveNames(archive.num_dives);
  return NameCauses(
      FindChanges(estimates, archive.num_dives, options), estimates, names, vehicle, options);
}

std::vector<std::string> CausesOf(const std::vector<ChangeEvent>& events) {
  std::vector<std::string> causes;
  for (const ChangeEvent& event : events) {
    causes.push_back(event.cause);
    for (const std::string& other : event.alternatives) causes.back() += " or " + other;
  }
  return causes;
}

void Scale(double factor, DiveEstimate* estimate) {
  estimate->value *= factor;
  estimate->covariance *= factor * factor;
}

Effect From(int at, const Effect& effect) {
  return [=](DiveEstimate* estimate) {
    if (estimate->dive >= at) effect(estimate);
  };
}

struct Difference {
  FreeEntry entry;
  double size;
};

// Of coupled models over twelve dives, of which those from the seventh on differ so.
std::vector<ChangeEvent> CoupledEvents(const std::vector<Difference>& differences) {
  constexpr int kNumDives = 12;
  RandomStream random(3, "archive");
  std::vector<DiveEstimate> estimates = DrawQuietCoupled(kNumDives, &random);
  for (DiveEstimate& estimate : estimates) {
    if (estimate.dive < 6) continue;
    for (const Difference& one : differences) {
      const auto found = std::find(estimate.entries.begin(), estimate.entries.end(), one.entry);
      estimate.value(found - estimate.entries.begin()) += one.size;
    }
  }
  const ChangeOptions options;
  return NameCauses(FindChanges(estimates, kNumDives, options),
                    estimates,
                    DiveNames(kNumDives),
                    ThreeThrusters(),
                    options);
}

TEST(NameCauses, NamesTheNumberOfACoupledModelThatChanges) {
  struct Case {
    std::vector<Difference> differences;
    std::string cause, text;
  };
  for (const Case& one : std::vector<Case>{
           {{{ThrustGainEntry("lateral"), -0.2}},
            "thruster(lateral)",
            "From dive 6 on the thrust of thruster lateral is "},
           {{{RightingMomentEntry(Dof::kRoll), -4.0}},
            "unnamed",
            "From dive 6 on the righting moment in roll is "},
           {{{InertiaEntry(Dof::kSurge, Dof::kSurge), 14.0},
             {InertiaEntry(Dof::kSway, Dof::kSway), 14.0},
             {InertiaEntry(Dof::kSway, Dof::kYaw), 3.0}},
            "payload",
            "From dive 6 on the vehicle is "},
           {{{OffsetEntry(Dof::kYaw), 0.2}}, "ballast", "From dive 6 on the offset in yaw is "}}) {
    const std::vector<ChangeEvent> events = CoupledEvents(one.differences);
    ASSERT_THAT(CausesOf(events), ElementsAre(one.cause)) << one.text;
    EXPECT_THAT(events[0].text, ::testing::StartsWith(one.text));
    for (const Difference& difference : one.differences) {
      const auto is_it = [&](const Change& change) { return change.entry == difference.entry; };
      EXPECT_TRUE(std::ranges::any_of(events[0].changes, is_it)) << one.text;
    }
  }
}

TEST(NameCauses, NamesEachCauseFromItsPattern) {
  const auto payload = [](double mass) {
    return From(12, [=](DiveEstimate* e) { e->value(kInertia) += IsAngular(e->dof) ? 0.0 : mass; });
  };
  const auto damping = [](double factor) {
    return From(12, [=](DiveEstimate* e) {
      e->value(kQuadraticDamping) *= factor;
      e->value(kLinearDamping) *= factor;
    });
  };
  const auto thrust = [](double factor) {
    return From(12, [=](DiveEstimate* e) {
      if (e->dof == Dof::kSurge) Scale(factor, e);
    });
  };
  const auto battery = [](double factor) {
    return From(12, [=](DiveEstimate* e) { Scale(factor, e); });
  };
  const auto ballast = [](double force) {
    return From(12, [=](DiveEstimate* e) {
      if (e->dof == Dof::kHeave) e->value(kBuoyancy) += force;
    });
  };
  const auto port = [](double weaker) {
    return From(12, [=](DiveEstimate* e) {
      if (e->dof != Dof::kHeave) Scale(1.0 / (1.0 - 0.5 * weaker), e);
    });
  };
  const auto excitation = [](double size) {
    return From(12, [=](DiveEstimate* e) {
      if (e->dof != Dof::kSurge) return;
      e->value(kQuadraticDamping) += 1.5 * size;
      e->value(kLinearDamping) -= 1.2 * size;
    });
  };
  const DrawnArchive archive;
  const auto causes = [&](const Effect& effect, const std::optional<Vehicle>& vehicle) {
    return CausesOf(EventsOf(archive, effect, vehicle));
  };
  EXPECT_THAT(causes(payload(14.0), {}), ElementsAre("payload"));
  EXPECT_THAT(causes(payload(-14.0), {}), ElementsAre("payload"));
  EXPECT_THAT(causes(damping(1.2), {}), ElementsAre("fouling"));
  EXPECT_THAT(causes(damping(0.8), {}), ElementsAre("cleaning"));
  EXPECT_THAT(causes(thrust(1.1), {}), ElementsAre("thrust(surge)"));
  EXPECT_THAT(causes(thrust(0.9), {}), ElementsAre("thrust(surge)"));
  EXPECT_THAT(causes(battery(1.1), {}), ElementsAre("battery"));
  EXPECT_THAT(causes(battery(0.9), ThreeThrusters()), ElementsAre("battery"));
  EXPECT_THAT(causes(ballast(2.0), {}), ElementsAre("ballast"));
  EXPECT_THAT(causes(ballast(-2.0), {}), ElementsAre("ballast"));
  EXPECT_THAT(causes(excitation(5.0), {}), ElementsAre("excitation"));
  EXPECT_THAT(causes(excitation(-5.0), {}), ElementsAre("excitation"));
  // Port and starboard push the same DOFs by the same shares.
  EXPECT_THAT(causes(port(0.2), ThreeThrusters()),
              ElementsAre("thruster(port) or thruster(starboard)"));
}

// How many of eight archives tell of fouling, of a payload from dive `payload` on and of a weak
// port thruster from dive `weak` on, give or take a dive, and of nothing else.
int NumToldApart(const DrawnArchive& archive, int payload, int weak) {
  Vehicle vehicle = ThreeThrusters();
  vehicle.thrusters[0].position.y() = -0.6;  // twice the moment of starboard
  int num_right = 0;
  for (int seed = 0; seed < 8; ++seed) {
    const auto events = EventsOf(
        archive,
        [&](DiveEstimate* e) {
          if (e->dive >= payload && !IsAngular(e->dof)) e->value(kInertia) += 14.0;
          const double growth = 1.0 + 0.01 * e->dive;
          e->value(kQuadraticDamping) *= growth;
          e->value(kLinearDamping) *= growth;
          // Port is half of surge and two thirds of yaw.
          const double share =
              e->dof == Dof::kSurge ? 0.5 : (e->dof == Dof::kYaw ? 2.0 / 3.0 : 0.0);
          if (e->dive >= weak) Scale(1.0 / (1.0 - 0.2 * share), e);
        },
        vehicle,
        seed);
    const bool has_all =
        CausesOf(events) == std::vector<std::string>{"fouling", "payload", "thruster(port)"};
    const bool is_right = has_all && std::abs(events[1].changes[0].at - payload) <= 1 &&
                          std::abs(events[2].changes[0].at - weak) <= 1;
    num_right += is_right ? 1 : 0;
  }
  return num_right;
}

TEST(NameCauses, TellsPayloadFoulingAndAWeakThrusterApart) {
  EXPECT_EQ(NumToldApart(DrawnArchive(), 10, 20), 8);
}

// Over few dives, damping that grows looks like a step of it with each step of another parameter.
TEST(NameCauses, TellsAPayloadAndAWeakThrusterFromFoulingOverTwelveDives) {
  DrawnArchive archive;
  archive.num_dives = 12;
  archive.std *= 0.25;
  EXPECT_GE(NumToldApart(archive, 4, 8), 7);
}

// Under a held heading the moments of port, 0.6 m out, and starboard, 0.3 m out, cancel. So port
// gets 1 / 3 of the surge force, and where it gives 20 % less, 1 / (1 + 2 * 0.8) of it.
TEST(NameCauses, NamesAWeakThrusterWhoseWorkAControllerShifts) {
  Vehicle vehicle = ThreeThrusters();
  vehicle.thrusters[0].position.y() = -0.6;
  DrawnArchive archive;
  archive.std *= 0.2;
  const auto shares_of = [](const DiveEstimate& e) {
    const double given = e.dive >= 20 ? 0.8 : 1.0;
    const double port = e.dof == Dof::kSurge ? 1.0 / (1.0 + 2.0 * given) : 2.0 / 3.0;
    return std::map<std::string, double>{{"port", port}, {"starboard", 1.0 - port}};
  };
  const auto events = EventsOf(
      archive,
      [&](DiveEstimate* e) {
        if (e->dof == Dof::kHeave) return;
        e->thruster_shares = shares_of(*e);
        if (e->dive >= 20) Scale(1.0 / (1.0 - 0.2 * e->thruster_shares["port"]), e);
      },
      vehicle);
  ASSERT_THAT(CausesOf(events), ElementsAre("thruster(port)"));
  EXPECT_THAT(events[0].text, ::testing::HasSubstr("20."));
}

TEST(NameCauses, NamesTwoCausesFromTheSameDiveOn) {
  const auto events = EventsOf(DrawnArchive(),
                               From(12,
                                    [](DiveEstimate* e) {
                                      if (!IsAngular(e->dof)) e->value(kInertia) += 14.0;
                                      if (e->dof == Dof::kHeave) e->value(kBuoyancy) += 2.0;
                                    }),
                               {});
  EXPECT_THAT(CausesOf(events), ::testing::UnorderedElementsAre("payload", "ballast"));
}

TEST(NameCauses, SaysWhatItCannotName) {
  const auto events = EventsOf(DrawnArchive(),
                               From(12,
                                    [](DiveEstimate* e) {
                                      if (e->dof == Dof::kSurge) e->value(kInertia) += 20.0;
                                      if (e->dof == Dof::kHeave) e->value(kInertia) -= 20.0;
                                    }),
                               {});
  EXPECT_THAT(CausesOf(events), ElementsAre("unnamed"));
}

}  // namespace
}  // namespace fathom
