// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ambiguous_boat.h"

#include "fathom/coupled/coupled_verdict_file.h"
#include "fathom/coupled_planning/verdict_rivals.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <random>

#include "boat_trial.h"
#include "drawn_vehicle.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kColourOfLog = 0.8;
constexpr double kFirstDuration = 200.0;  // [s]

}  // namespace

AmbiguousBoat DrawAmbiguousBoat(const HiddenCause& hidden, unsigned seed) {
  std::mt19937 random(seed);
  AmbiguousBoat boat;
  boat.truth = DrawnPlanarVehicle(&random);
  SetValue(ParseFreeEntry(hidden.entry),
           std::uniform_real_distribution<double>(hidden.least, hidden.most)(random),
           &boat.truth);
  CoupledIdentificationOptions how;
  how.dofs = boat.truth.dofs;
  DrawnLogOptions log;
  log.duration = kFirstDuration;
  log.colour = kColourOfLog;
  const CoupledIdentification found =
      IdentifyCoupled({LogFileOf(DrawnLog(boat.truth, log, &random))}, how);
  EXPECT_TRUE(found.is_usable) << found.message;
  boat.fitted = found.fitted;
  boat.verdict = FormatCoupledVerdict(DiagnoseCoupled(found, {}), found);
  return boat;
}

CoupledPlanRequest RivalRequest(const AmbiguousBoat& boat, double duration, double effort) {
  CoupledPlanRequest request = BoatRequest({boat.truth, boat.fitted}, duration, effort);
  request.rivals = ReadVerdictRivals(request.name, boat.verdict, boat.fitted).pairs;
  return request;
}

Ladder LadderOfPlayed(const CoupledModel& truth,
                      const CoupledCommand& command,
                      double duration,
                      unsigned seed) {
  CoupledLogs logs;
  logs.data = {PlayedLog(truth, command, duration, kBoatNoise, seed, kColourOfLog)};
  return ClimbLadder(logs, truth.dofs, {});
}

}  // namespace fathom
