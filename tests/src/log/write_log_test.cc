// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/write_log.h"

#include "fathom/base/files/input_file.h"
#include "fathom/log/log_yaml.h"
#include "fathom/log/read_log.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

// Not there yet.
std::filesystem::path Folder() { return EmptyTestFolder() / "log"; }

// Equal to the bit, so that -0 is not 0.
void ExpectSameNumbers(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i])) << i;
  }
}

void ExpectSameStream(const std::optional<Stream>& a, const std::optional<Stream>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->columns, b->columns);
  ExpectSameNumbers(a->time, b->time);
  ASSERT_EQ(a->values.size(), b->values.size());
  for (std::size_t i = 0; i < a->values.size(); ++i) ExpectSameNumbers(a->values[i], b->values[i]);
}

void ExpectSameLog(const Log& a, const Log& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.dofs, b.dofs);
  EXPECT_EQ(a.vehicle, b.vehicle);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.command_unit, b.command_unit);
  EXPECT_EQ(a.video, b.video);
  EXPECT_EQ(a.video_start, b.video_start);
  EXPECT_EQ(a.dive, b.dive);
  EXPECT_EQ(a.start, b.start);
  ASSERT_EQ(a.held_out.size(), b.held_out.size());
  for (std::size_t i = 0; i < a.held_out.size(); ++i) {
    ExpectSameNumbers({a.held_out[i].from, a.held_out[i].to},
                      {b.held_out[i].from, b.held_out[i].to});
  }
  ExpectSameStream(a.command, b.command);
  ExpectSameStream(a.velocity, b.velocity);
  ExpectSameStream(a.pose, b.pose);
  ExpectSameStream(a.detections, b.detections);
}

Stream RandomStream(const std::vector<std::string>& columns, int num_rows) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Stream stream{.time = {}, .columns = columns, .values = {}};
  stream.values.resize(columns.size());
  double t = 1433350639.315205;
  for (int row = 0; row < num_rows; ++row) {
    stream.time.push_back(t);
    t += 0.1 + 0.05 * uniform(generator);
    for (auto& column : stream.values) column.push_back(uniform(generator));
  }
  return stream;
}

Log FullLog() {
  Log log;
  log.name = "a \"quoted\" name: # yes";
  log.dofs = {Dof::kHeave, Dof::kYaw};
  log.vehicle = "rov.yaml";
  log.notes = "first line\n  second\tline \\ with caf\xc3\xa9\n\n- and: more\n";
  log.command_unit = "A";
  log.video = "dive: 1.mp4";
  log.video_start = 1433350639.5;
  log.dive = "harbour: 3";
  log.start = 1777818605.0;
  log.held_out = {{.from = 1433350640.1, .to = 1433350641.0 / 3.0 * 3.0},
                  {.from = -1e-3, .to = 0.1}};
  log.command = RandomStream({"tau_heave", "tau_yaw"}, 50);
  log.velocity = RandomStream({"w", "r"}, 60);
  log.velocity->values[0][0] = -0.0;
  log.velocity->values[0][1] = std::numeric_limits<double>::denorm_min();
  log.velocity->values[0][2] = std::numeric_limits<double>::max();
  log.velocity->values[0][3] = 0.1 + 0.2;
  log.pose = RandomStream({"x", "y", "z"}, 40);
  for (const double q : {0.5, -0.5, 0.5, 0.5})
    log.pose->values.push_back(std::vector<double>(40, q));
  for (const char* name : {"qx", "qy", "qz", "qw"}) log.pose->columns.emplace_back(name);
  return log;
}

TEST(WriteLog, IsReadBackToTheBit) {
  const auto folder = Folder();
  const Log log = FullLog();
  WriteLog(folder, log);
  ExpectSameLog(ReadLog(folder), log);
}

TEST(WriteLog, KeepsWhatIsOddAboutTheStampsOfARecording) {
  Log log;
  log.name = "odd";
  log.dofs = {Dof::kSurge};
  log.origin = {"dive.csv", "", "", {{"velocity", 0.0984}}, "index"};
  const Log again = ParseLogYaml("log.yaml", FormatLogYaml(log));
  EXPECT_EQ(again.origin->row_counter, "index");
  ASSERT_EQ(again.origin->out_of_order.size(), 1U);
  EXPECT_EQ(again.origin->out_of_order[0].stream, "velocity");
  EXPECT_EQ(again.origin->out_of_order[0].share, 0.0984);
}

// The velocities that it writes are corrected; log.yaml alone goes beside the file as it was.
TEST(WriteLog, WritesNoCorrectionThatIsMade) {
  Log log;
  log.name = "a";
  log.dofs = {Dof::kSurge};
  log.velocity = Stream{{0, 1}, {"u"}, {{-1, -2}}};
  log.corrections = {{"u", -1}};
  EXPECT_THAT(FormatLogYaml(log), ::testing::HasSubstr("correct: {u: -1}"));
  const auto folder = Folder();
  std::filesystem::create_directories(folder);
  WriteLog(folder, log);
  EXPECT_THAT(ReadFile(folder / "log.yaml"), ::testing::Not(::testing::HasSubstr("correct")));
}

TEST(WriteLog, WritesOnlyWhatThereIs) {
  const auto folder = Folder();
  Log log = FullLog();
  log.pose.reset();
  log.held_out.clear();
  log.notes.clear();
  log.command->columns = {"thruster_1", "thruster_2"};
  WriteLog(folder, log);
  EXPECT_FALSE(std::filesystem::exists(folder / "pose.csv"));
  ExpectSameLog(ReadLog(folder), log);
}

TEST(WriteLog, ReplacesAnEarlierLogButRefusesToLeaveAStreamOfItBehind) {
  const auto folder = Folder();
  Log log = FullLog();
  WriteLog(folder, log);
  log.name = "second";
  WriteLog(folder, log);
  EXPECT_EQ(ReadLog(folder).name, "second");
  log.pose.reset();
  EXPECT_THAT(ErrorFrom([&] { WriteLog(folder, log); }),
              ::testing::StartsWith((folder / "pose.csv").string() + ": is left from another log"));
}

TEST(WriteStream, WritesTheFewestDigits) {
  const auto file = Folder() / "a.csv";
  WriteStream(file,
              {.time = {0.0, 0.1}, .columns = {"u", "v"}, .values = {{1.0, -2.5e-7}, {0.3, 1e22}}});
  EXPECT_EQ(ReadFile(file), "t,u,v\n0,1,0.3\n0.1,-2.5e-07,1e+22\n");
}

}  // namespace
}  // namespace fathom
