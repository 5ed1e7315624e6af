// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/signal_check.h"

#include "fathom/log/log.h"
#include "fathom/log/read_log.h"

#include <cmath>
#include <random>

#include "real_data.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

auto Has(const char* code) { return Contains(Field(&Finding::code, code)); }

// A steady sine: velocity lags the force as mass and linear damping make it, plus `delay`.
Log SineLog(double delay, double force_sign = 1.0) {
  const double m = 100.0, d = 30.0, w = 0.3, amplitude = 10.0;
  const double phase = std::atan2(m * w, d), gain = 1.0 / std::hypot(m * w, d);
  std::mt19937 generator(2);
  std::normal_distribution<double> normal(0.0, 0.005);
  Log log;
  log.command = Stream{.time = {}, .columns = {"tau_surge"}, .values = {{}}};
  log.velocity = Stream{.time = {}, .columns = {"u"}, .values = {{}}};
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.1 * i;
    log.command->time.push_back(t);
    log.command->values[0].push_back(5.0 + force_sign * amplitude * std::sin(w * t));
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(amplitude * gain * std::sin(w * (t - delay) - phase) +
                                      normal(generator));
  }
  return log;
}

TEST(SignalCheck, FindsNothingInAVehicleThatBehaves) {
  EXPECT_THAT(CheckSignals(SignalsOf(SineLog(0.0), Dof::kSurge)), IsEmpty());
}

TEST(SignalCheck, FindsAWrongSignOfTheForce) {
  const auto findings = CheckSignals(SignalsOf(SineLog(0.0, -1.0), Dof::kSurge));
  EXPECT_THAT(findings, Has("passivity"));
  EXPECT_THAT(findings, Has("force_sign"));
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  // Amplitudes 10 N and 10 / 42.4 m/s, 45 degrees apart: -10 * 0.2357 / 2 * cos(45) = -0.833 W
  // over whole periods.
  EXPECT_THAT(findings[0].sentence, HasSubstr("is -0.84"));
}

// Driven along by 45 N at 1 m/s, a ship slows down in turns, and its propeller then pushes more.
TEST(SignalCheck, OnlyNotesAForceThatRisesWhereTheVehicleSlowsDown) {
  Log log = SineLog(0.0, -1.0);
  for (double& force : log.command->values[0]) force += 40.0;
  for (double& v : log.velocity->values[0]) v += 1.0;
  const auto findings = CheckSignals(SignalsOf(log, Dof::kSurge));
  ASSERT_THAT(findings, Has("passivity"));
  for (const Finding& finding : findings) {
    if (finding.code != "passivity") continue;
    EXPECT_EQ(finding.severity, Severity::kNote);
    EXPECT_THAT(finding.sentence, HasSubstr("is -0.84"));
  }
}

// 45 degrees of lag and 7.9 s of delay (135 degrees) make 180.
TEST(SignalCheck, FindsADelayOfOverAQuarterPeriod) {
  EXPECT_THAT(CheckSignals(SignalsOf(SineLog(7.9), Dof::kSurge)), Has("passivity"));
}

TEST(SignalCheck, IgnoresABuoyancyThatWorksAgainstTheForce) {
  // A constant push down of 5 N while the vehicle drifts up: no sign error in what varies.
  Log log = SineLog(0.0);
  for (double& v : log.velocity->values[0]) v -= 0.5;
  EXPECT_THAT(CheckSignals(SignalsOf(log, Dof::kSurge)), Not(Has("passivity")));
}

TEST(SignalCheck, FindsSpeedsThatCannotBe) {
  Log log = SineLog(0.0);
  for (double& v : log.velocity->values[0]) v *= 1000.0;  // mm/s
  EXPECT_THAT(CheckSignals(SignalsOf(log, Dof::kSurge)),
              Contains(AllOf(Field(&Finding::code, "speed_range"),
                             Field(&Finding::sentence, HasSubstr("m/s")))));
}

TEST(SignalCheck, NotesTurnsThatNoVehicleMakesButAMotorDoes) {
  Log log = SineLog(0.0);
  log.command->columns = {"tau_yaw"};
  log.velocity->columns = {"r"};
  for (double& v : log.velocity->values[0]) v *= 1000.0;
  EXPECT_THAT(CheckSignals(SignalsOf(log, Dof::kYaw)),
              Contains(AllOf(Field(&Finding::code, "speed_range"),
                             Field(&Finding::severity, Severity::kNote),
                             Field(&Finding::sentence, HasSubstr("deg/s")))));
}

TEST(SignalCheck, FindsACommandAndAVelocityThatNeverChange) {
  Log log = SineLog(0.0);
  for (double& tau : log.command->values[0]) tau = 3.0;
  EXPECT_THAT(CheckSignals(SignalsOf(log, Dof::kSurge)), Has("constant_command"));
  for (double& v : log.velocity->values[0]) v = 0.0;
  EXPECT_THAT(CheckSignals(SignalsOf(log, Dof::kSurge)), Has("constant_velocity"));
}

TEST(SignalCheck, FindsStampsThatAreNotSeconds) {
  Log log = SineLog(0.0);
  for (double& t : log.command->time) t *= 1000.0;
  for (double& t : log.velocity->time) t *= 1000.0;
  EXPECT_THAT(CheckSignals(SignalsOf(log, Dof::kSurge, {.longest_gap = 1e6})),
              Has("sampling_rate"));
}

TEST(SignalCheck, NotesJitterAndGaps) {
  Log log = SineLog(0.0);
  Stream& velocity = *log.velocity;
  velocity.time.erase(velocity.time.begin() + 500, velocity.time.begin() + 520);
  velocity.values[0].erase(velocity.values[0].begin() + 500, velocity.values[0].begin() + 520);
  const auto findings = CheckSignals(SignalsOf(log, Dof::kSurge));
  EXPECT_THAT(findings, Has("jitter"));
  EXPECT_THAT(findings,
              Contains(AllOf(Field(&Finding::code, "gap"),
                             Field(&Finding::severity, Severity::kNote),
                             Field(&Finding::sentence, HasSubstr("2.1 s")))));
}

// Clean runs under a random command: a warning is an alarm, so a false one must be rare.
// Samples at 10 Hz that arrive four at once are told; as many that are dropped are not.
TEST(SignalCheck, FindsStampsThatCameInBatches) {
  Log log = SineLog(0.0);
  std::vector<double>& time = log.velocity->time;
  for (std::size_t i = 0; i < time.size(); ++i) {
    time[i] = 0.4 * static_cast<double>(i / 4 + 1) + 0.01 * static_cast<double>(i % 4);
  }
  const auto findings = CheckSignals(SignalsOf(log, Dof::kSurge));
  EXPECT_THAT(findings, Has("arrival_stamps"));
  EXPECT_THAT(findings, Not(Has("jitter")));

  Log dropped = SineLog(0.0);
  Stream sparse = {.time = {}, .columns = {"u"}, .values = {{}}};
  for (std::size_t i = 0; i < 3000; ++i) {
    if (i % 5 > 2) continue;
    sparse.time.push_back(dropped.velocity->time[i]);
    sparse.values[0].push_back(dropped.velocity->values[0][i]);
  }
  dropped.velocity = sparse;
  EXPECT_THAT(CheckSignals(SignalsOf(dropped, Dof::kSurge)), Not(Has("arrival_stamps")));
}

TEST(SignalCheck, RarelyWarnsWithoutReason) {
  int num_warnings = 0;
  const int num_runs = 200;
  for (int seed = 0; seed < num_runs; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    Segment segment;
    double v = 0.0, tau = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double t = 0.1 * i;
      tau = 0.98 * tau + normal(generator);
      segment.time.push_back(t);
      segment.command.time.push_back(t);
      segment.command.value.push_back(tau);
      segment.velocity.push_back(v + 0.05 * normal(generator));
      v += 0.1 * (tau - 30.0 * v) / 100.0;
    }
    for (const Finding& finding : CheckSignals(std::vector<Segment>{segment}, Dof::kSurge, "N")) {
      num_warnings += finding.severity == Severity::kWarning;
    }
  }
  EXPECT_LE(num_warnings, num_runs / 100);
}

using SignalCheckOnRealLogs = OnRealData;

TEST_F(SignalCheckOnRealLogs, WarnsOfTheYawRunThatReturnsEnergy) {
  const Log log = ReadLog(folder_ / "lbv_yaw");
  EXPECT_THAT(CheckSignals(SignalsOf(log, Dof::kYaw)), Has("passivity"));
}

TEST_F(SignalCheckOnRealLogs, DoesNotWarnOfTheOthers) {
  const Log surge =
      ReadLog(folder_ / "lbv_surge",
              {.dof = std::nullopt, .velocity = folder_ / "lbv_surge" / "author_velocity.csv"});
  const Log pool = ReadLog(folder_ / "pool_rov_surge");
  for (const Signals& signals : {SignalsOf(surge, Dof::kSurge),
                                 SignalsOf(surge, Dof::kSurge, {.source = Source::kCamera}),
                                 SignalsOf(pool, Dof::kSurge)}) {
    for (const Finding& finding : CheckSignals(signals)) {
      EXPECT_EQ(finding.severity, Severity::kNote) << finding.sentence;
    }
  }
}

}  // namespace
}  // namespace fathom
