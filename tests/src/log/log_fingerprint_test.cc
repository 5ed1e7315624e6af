// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_fingerprint.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace fathom {
namespace {

Log SmallLog() {
  Log log;
  log.name = "small";
  log.path = "somewhere/small";
  log.command = Stream{{0.0, 1.0}, {"tau_surge"}, {{2.0, 3.0}}};
  log.velocity = Stream{{0.5, 1.5}, {"u"}, {{0.1, 0.2}}};
  return log;
}

TEST(LogFingerprint, DoesNotDependOnNameOrFolder) {
  Log moved = SmallLog();
  moved.name = "renamed";
  moved.path = "elsewhere";
  moved.notes = "copied";
  EXPECT_EQ(FingerprintOf(moved), FingerprintOf(SmallLog()));
  EXPECT_EQ(FingerprintOf(moved).size(), 16u);
}

TEST(LogFingerprint, DoesNotDependOnPosesThatAreMadeFromDetections) {
  Log log = SmallLog();
  log.detections = Stream{{0.5, 0.5}, {"tag_id"}, {{1.0, 2.0}}};
  const std::string before = FingerprintOf(log);
  log.pose = Stream{{0.5}, {"x"}, {{1.0}}};
  EXPECT_EQ(FingerprintOf(log), before);
}

TEST(LogFingerprint, ChangesWithEveryPieceOfTheData) {
  std::set<std::string> fingerprints = {FingerprintOf(SmallLog())};
  Log log = SmallLog();
  log.command->values[0][1] = 3.0000000000000004;  // the next double
  fingerprints.insert(FingerprintOf(log));
  log = SmallLog();
  log.velocity->time[0] = 0.4;
  fingerprints.insert(FingerprintOf(log));
  log = SmallLog();
  log.velocity->columns[0] = "v";
  fingerprints.insert(FingerprintOf(log));
  log = SmallLog();
  log.pose = log.velocity;
  log.velocity.reset();
  fingerprints.insert(FingerprintOf(log));
  log = SmallLog();
  log.detections = Stream{{0.5, 0.5}, {"tag_id"}, {{1.0, 2.0}}};
  fingerprints.insert(FingerprintOf(log));
  log.detections->values[0][1] = 3.0;
  fingerprints.insert(FingerprintOf(log));
  EXPECT_EQ(fingerprints.size(), 7u);
}

TEST(FingerprintsOf, AreThoseOfTheLogsInTheirOrder) {
  Log other = SmallLog();
  other.velocity->time[0] = 0.4;
  const std::vector<Log> logs = {other, SmallLog()};
  EXPECT_EQ(FingerprintsOf(logs),
            (std::vector<std::string>{FingerprintOf(other), FingerprintOf(SmallLog())}));
}

}  // namespace
}  // namespace fathom
