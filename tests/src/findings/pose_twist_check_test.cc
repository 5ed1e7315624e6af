// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pose_twist_check.h"

#include "fathom/base/random_stream.h"
#include "fathom/log/read_log.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "real_data.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Two minutes at 10 Hz of a vehicle that surges along x and turns, measured by poses and by
// velocities; `change` spoils u and r.
Log TwoMotions(const std::function<void(double t, double* u, double* r)>& change,
               double delay = 0.0) {
  RandomStream random(4, "two motions");
  Log log;
  log.pose = Stream{{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, {}};
  log.pose->values.resize(7);
  log.velocity = Stream{{}, {"u", "r"}, {{}, {}}};
  for (int i = 0; i < 1200; ++i) {
    const double t = 0.1 * i;
    // The heading turns, the path is along it.
    const double yaw = 0.4 * std::sin(0.3 * t);
    log.pose->time.push_back(t);
    const double along = 0.6 * std::sin(0.5 * t) / 0.5;
    const std::vector<double> row = {
        along, 0.0, 0.0, 0.0, 0.0, std::sin(yaw / 2), std::cos(yaw / 2)};
    for (int k = 0; k < 7; ++k) {
      const double noise = k < 3 ? 0.005 * random.Normal() : 0.0;
      log.pose->values[k].push_back(row[k] + noise);
    }
    const double s = t - delay;
    double u = 0.6 * std::cos(0.5 * s) * std::cos(0.4 * std::sin(0.3 * s)) + 0.02 * random.Normal();
    double r = 0.4 * 0.3 * std::cos(0.3 * s) + 0.01 * random.Normal();
    change(t, &u, &r);
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(u);
    log.velocity->values[1].push_back(r);
  }
  return log;
}

TEST(PoseAgainstTwist, SaysNothingOfOneMotionMeasuredTwice) {
  EXPECT_THAT(CheckPoseAgainstTwist(TwoMotions([](double, double*, double*) {})), IsEmpty());
}

// A roll that changes its speed within a window of the filter, measured without noise.
TEST(PoseAgainstTwist, SaysNothingOfAFastMotion) {
  Log log;
  log.pose = Stream{{}, {"qx", "qy", "qz", "qw"}, std::vector<std::vector<double>>(4)};
  log.velocity = Stream{{}, {"p"}, {{}}};
  constexpr double kRate = 5.0;  // [rad/s]
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.02 * i, roll = 0.3 * std::sin(kRate * t) + 0.2 * std::sin(0.4 * t);
    log.pose->time.push_back(t);
    const double row[] = {std::sin(roll / 2), 0.0, 0.0, std::cos(roll / 2)};
    for (int k = 0; k < 4; ++k) log.pose->values[k].push_back(row[k]);
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(0.3 * kRate * std::cos(kRate * t) +
                                      0.2 * 0.4 * std::cos(0.4 * t));
  }
  EXPECT_THAT(CheckPoseAgainstTwist(log), IsEmpty());
}

// One motion at an even rate, whose samples arrive in batches of one to six: the truth is a factor
// of 1.
TEST(PoseAgainstTwist, SaysNothingOfTheScaleWhereStampsAreThoseOfArrival) {
  RandomStream random(5, "arrival");
  Log log;
  log.pose =
      Stream{{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, std::vector<std::vector<double>>(7)};
  log.velocity = Stream{{}, {"u"}, {{}}};
  for (int i = 0; i < 1000;) {
    const int batch = 1 + static_cast<int>(6.0 * random.Uniform());
    for (int k = 0; k < batch; ++k, ++i) {
      const double t = 0.12 * i, arrival = 0.12 * (i - k + batch) + 0.04 * k;
      const double row[] = {1.2 * std::sin(0.5 * t), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
      log.pose->time.push_back(arrival);
      for (int j = 0; j < 7; ++j)
        log.pose->values[j].push_back(row[j] + (j < 3 ? 0.002 * random.Normal() : 0.0));
      log.velocity->time.push_back(arrival);
      log.velocity->values[0].push_back(0.6 * std::cos(0.5 * t) + 0.02 * random.Normal());
    }
  }
  EXPECT_THAT(CheckPoseAgainstTwist(log), IsEmpty());
}

TEST(PoseAgainstTwist, FindsAWrongSignOfOneAxis) {
  const auto findings =
      CheckPoseAgainstTwist(TwoMotions([](double, double*, double* r) { *r = -*r; }));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "pose_twist_sign");
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_THAT(findings[0].sentence, HasSubstr("r and the yaw velocity"));
  EXPECT_THAT(findings[0].sentence, HasSubstr("a factor of -1 (-1.0"));
}

// Rows are missing for 20 s at a time, as where a log was paused: the windows stay short.
TEST(PoseAgainstTwist, FindsAWrongUnitBesideLongGaps) {
  Log log = TwoMotions([](double, double* u, double*) { *u *= 4.0; });
  const auto keep = [](const Stream& all) {
    Stream kept = {{}, all.columns, std::vector<std::vector<double>>(all.columns.size())};
    for (std::size_t i = 0; i < all.time.size(); ++i) {
      if (std::fmod(all.time[i], 40.0) >= 20.0) continue;
      kept.time.push_back(all.time[i]);
      for (std::size_t k = 0; k < all.values.size(); ++k) {
        kept.values[k].push_back(all.values[k][i]);
      }
    }
    return kept;
  };
  log.pose = keep(*log.pose);
  log.velocity = keep(*log.velocity);
  const auto findings = CheckPoseAgainstTwist(log);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "pose_twist_scale");
}

TEST(PoseAgainstTwist, FindsAWrongUnit) {
  const auto findings =
      CheckPoseAgainstTwist(TwoMotions([](double, double* u, double*) { *u *= 100; }));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "pose_twist_scale");
  EXPECT_THAT(findings[0].sentence, HasSubstr("by a factor of 1"));
}

TEST(PoseAgainstTwist, FindsADelay) {
  const auto findings = CheckPoseAgainstTwist(TwoMotions([](double, double*, double*) {}, 1.2));
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].code, "pose_twist_delay");
  EXPECT_EQ(findings[0].severity, Severity::kNote);
  EXPECT_THAT(findings[0].sentence, HasSubstr("velocity.csv is 1.2"));
}

TEST(PoseAgainstTwist, FindsMotionsThatAreNotOne) {
  const auto findings = CheckPoseAgainstTwist(
      TwoMotions([](double t, double* u, double*) { *u = 0.5 * std::sin(1.7 * t); }));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "pose_twist_apart");
}

TEST(PoseAgainstTwist, SaysNothingOfAnAxisThatHardlyMoves) {
  RandomStream random(5, "rest");
  Log log = TwoMotions([&](double, double* u, double*) { *u = 0.001 * random.Normal(); });
  EXPECT_THAT(CheckPoseAgainstTwist(log), IsEmpty());
}

// Two minutes of a vehicle that goes about 0.5 m/s ahead and 0.1 m/s aside and turns round several
// times. Its velocities are told along its own axes, or along those of the world.
Log InACircle(bool is_in_world) {
  RandomStream random(6, "circle");
  Log log;
  log.pose = Stream{{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, {}};
  log.pose->values.resize(7);
  log.velocity = Stream{{}, {"u", "v"}, {{}, {}}};
  double x = 0.0, y = 0.0;
  for (int i = 0; i < 1200; ++i) {
    const double t = 0.1 * i, yaw = 0.2 * t;
    const double ahead = 0.5 + 0.1 * std::sin(0.7 * t), aside = 0.1 + 0.1 * std::sin(0.4 * t);
    const double to_x = ahead * std::cos(yaw) - aside * std::sin(yaw);
    const double to_y = ahead * std::sin(yaw) + aside * std::cos(yaw);
    x += 0.1 * to_x;
    y += 0.1 * to_y;
    const double row[] = {x, y, 0.0, 0.0, 0.0, std::sin(yaw / 2), std::cos(yaw / 2)};
    log.pose->time.push_back(t);
    for (int k = 0; k < 7; ++k) {
      log.pose->values[k].push_back(row[k] + (k < 3 ? 0.005 * random.Normal() : 0.0));
    }
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back((is_in_world ? to_x : ahead) + 0.03 * random.Normal());
    log.velocity->values[1].push_back((is_in_world ? to_y : aside) + 0.03 * random.Normal());
  }
  return log;
}

TEST(PoseAgainstTwist, FindsVelocitiesAlongTheWorld) {
  EXPECT_THAT(CheckPoseAgainstTwist(InACircle(false)), IsEmpty());
  const auto findings = CheckPoseAgainstTwist(InACircle(true));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "pose_twist_frame");
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_THAT(findings[0].sentence, HasSubstr("u, v are along the axes of the world"));
}

// What SPOILERS.md of these logs tells of them.
class PoseAgainstTwistOfRealLogs : public OnRealData {
 protected:
  std::vector<std::string> Codes(const std::string& log) {
    std::vector<std::string> codes;
    for (const Finding& finding : CheckPoseAgainstTwist(ReadLog(folder_ / log))) {
      codes.push_back(finding.code +
                      finding.sentence.substr(std::string("velocity.csv:").size(), 2));
    }
    return codes;
  }
};

TEST_F(PoseAgainstTwistOfRealLogs, FindsTheWrongSignsAndTheDelayOfAnAuv) {
  EXPECT_THAT(Codes("auv_6dof/random_2"),
              ElementsAre("pose_twist_delay u",
                          "pose_twist_delay v",
                          "pose_twist_delay w",
                          "pose_twist_sign p",
                          "pose_twist_sign q"));
}

TEST_F(PoseAgainstTwistOfRealLogs, SaysNothingOfASignThatIsCorrected) {
  const Log log =
      ReadLog(folder_ / "auv_6dof/random_2", {.corrections = {{"p", -1.0}, {"q", -1.0}}});
  for (const Finding& finding : CheckPoseAgainstTwist(log)) {
    EXPECT_EQ(finding.code, "pose_twist_delay") << finding.sentence;
  }
}

TEST_F(PoseAgainstTwistOfRealLogs, FindsVelocitiesOverGroundThatAreCalledThoseOfTheBody) {
  EXPECT_THAT(Codes("ship_zigzags/zigzag_20_05"), ElementsAre("pose_twist_frame u"));
}

}  // namespace
}  // namespace fathom
