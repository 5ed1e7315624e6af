// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Files that vehicles' own software wrote, held against what other decoders found in them.

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "real_data.h"
#include "scratch_file.h"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using RealRecordings = OnRealData;
using Json = nlohmann::json;

// A file that Python wrote, which writes NaN where JSON has null.
Json ReadJson(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (std::size_t at = text.find("NaN"); at != std::string::npos; at = text.find("NaN", at)) {
    text.replace(at, 3, "null");
  }
  return Json::parse(text);
}

// Counts and stamps of the messages of one type, all instances together.
struct TypeSpan {
  std::uint64_t count = 0;
  double first = 1e300;
  double last = -1e300;
};

std::map<std::string, TypeSpan> SpansOf(const Contents& contents) {
  std::map<std::string, TypeSpan> spans;
  for (const Channel& channel : contents.channels) {
    TypeSpan& span = spans[channel.type];
    span.count += channel.count;
    if (!channel.first) continue;
    span.first = std::min(span.first, *channel.first);
    span.last = std::max(span.last, *channel.last);
  }
  return spans;
}

TEST_F(RealRecordings, DataflashLogsHoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats" / "bin";
  const Json references = ReadJson(folder / "reference.json");
  for (const auto& [name, reference] : references.items()) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(folder / name);
    const Contents& contents = recording->contents();
    const auto spans = SpansOf(contents);
    EXPECT_EQ(spans.size(), reference["counts"].size());
    for (const auto& [type, count] : reference["counts"].items()) {
      ASSERT_TRUE(spans.contains(type)) << type;
      EXPECT_EQ(spans.at(type).count, count.get<std::uint64_t>()) << type;
    }
    for (const auto& [type, span] : reference["first_last_s"].items()) {
      EXPECT_NEAR(spans.at(type).first, std::stod(span[0].get<std::string>()), 1e-7) << type;
      EXPECT_NEAR(spans.at(type).last, std::stod(span[1].get<std::string>()), 1e-7) << type;
    }
    EXPECT_EQ(contents.size_bytes - contents.read_bytes,
              reference["tail"]["bytes"].get<std::uint64_t>());
  }
}

TEST_F(RealRecordings, DataflashValuesAreInTheUnitsThatTheLogStates) {
  const auto recording = OpenRecording(folder_ / "formats" / "bin" / "ardusub_3.7_sitl.BIN");
  // reference.json: raw ATT.Roll -17986 centidegrees, CTUN.CRt -4 cm/s, XKF1-like NKF1.PD 0.293144.
  const Selection selections[] = {
      {"ATT", {"Roll", "Yaw"}}, {"CTUN", {"CRt"}}, {"NKF1", {"PD", "Yaw"}}, {"RCOU", {"C6"}}};
  std::map<std::size_t, std::vector<double>> first;
  recording->Read(selections, [&](std::size_t i, double, std::span<const double> values) {
    first.try_emplace(i, values.begin(), values.end());
  });
  EXPECT_DOUBLE_EQ(first[0][0], -179.86);
  EXPECT_DOUBLE_EQ(first[0][1], 359.71);
  EXPECT_DOUBLE_EQ(first[1][0], -0.04);
  EXPECT_FLOAT_EQ(static_cast<float>(first[2][0]), 0.293144F);
  EXPECT_DOUBLE_EQ(first[2][1], 359.70);
  EXPECT_EQ(first[3][0], 1500.0);
}

TEST_F(RealRecordings, ACompleteDataflashLogIsComplete) {
  const auto recording = OpenRecording(folder_ / "formats" / "ardusub_small.BIN");
  EXPECT_TRUE(recording->contents().IsComplete());
  const auto spans = SpansOf(recording->contents());
  EXPECT_EQ(spans.size(), 39U);
  EXPECT_EQ(spans.at("IMU").count, 594U);
  EXPECT_EQ(spans.at("PARM").count, 876U);
  EXPECT_NEAR(spans.at("RCOU").last, 289.338, 5e-4);
}

// Counts and stamps by "topic_instance", and what is not data by the letter of its messages.
TEST_F(RealRecordings, UlogFilesHoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats" / "ulog";
  const Json references = ReadJson(folder / "reference.json");
  EXPECT_EQ(references.size(), 2U);
  for (const auto& [name, reference] : references.items()) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(folder / name);
    const Contents& contents = recording->contents();
    EXPECT_EQ(contents.size_bytes - contents.read_bytes,
              reference["bytes_left"].get<std::uint64_t>());
    EXPECT_EQ(contents.channels.size(), reference["messages"].size());
    std::uint64_t num_data = 0;
    for (const Channel& channel : contents.channels) {
      SCOPED_TRACE(channel.name);
      const std::string instance =
          channel.name == channel.type
              ? "0"
              : channel.name.substr(channel.type.size() + 1,
                                    channel.name.find(']') - channel.type.size() - 1);
      ASSERT_TRUE(reference["messages"].contains(channel.type + "_" + instance));
      const Json& message = reference["messages"][channel.type + "_" + instance];
      EXPECT_EQ(channel.count, message["count"].get<std::uint64_t>());
      EXPECT_NEAR(*channel.first, 1e-6 * message["first"].get<double>(), 1e-9);
      EXPECT_NEAR(*channel.last, 1e-6 * message["last"].get<double>(), 1e-9);
      EXPECT_FALSE(channel.fields.empty());
      num_data += channel.count;
    }
    const Json& kinds = reference["kinds"];
    const auto count = [&](const char* kind) { return kinds.value(kind, std::uint64_t{0}); };
    EXPECT_EQ(num_data, count("D"));
    std::string remarks;
    for (const std::string& remark : contents.remarks) remarks += remark + "\n";
    const auto expect_remark = [&](const std::string& text) {
      EXPECT_NE(remarks.find(text), std::string::npos) << text << " in " << remarks;
    };
    expect_remark(fmt::format("{} parameters, {} messages of information, {} text",
                              count("P"),
                              count("I") + count("M"),
                              count("L")));
    if (count("O") > 0) expect_remark(fmt::format("{} dropout", count("O")));
  }
}

// Every packet's checksum holds, counts by number are those of the reference, and so are first and
// last values.
TEST_F(RealRecordings, ATelemetryLogHoldsWhatItsReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats";
  const Json reference = ReadJson(folder / "reference.json")["ardusub_small.tlog"];
  const auto recording = OpenRecording(folder / "ardusub_small.tlog");
  const Contents& contents = recording->contents();
  EXPECT_EQ(contents.format, "tlog");
  EXPECT_TRUE(contents.IsComplete());
  std::map<std::string, std::string> number_of;
  const auto known = {std::pair("0", "HEARTBEAT"),
                      std::pair("1", "SYS_STATUS"),
                      std::pair("22", "PARAM_VALUE"),
                      std::pair("27", "RAW_IMU"),
                      std::pair("29", "SCALED_PRESSURE"),
                      std::pair("30", "ATTITUDE"),
                      std::pair("32", "LOCAL_POSITION_NED"),
                      std::pair("33", "GLOBAL_POSITION_INT"),
                      std::pair("36", "SERVO_OUTPUT_RAW"),
                      std::pair("65", "RC_CHANNELS"),
                      std::pair("69", "MANUAL_CONTROL"),
                      std::pair("74", "VFR_HUD"),
                      std::pair("116", "SCALED_IMU2"),
                      std::pair("137", "SCALED_PRESSURE2"),
                      std::pair("147", "BATTERY_STATUS")};
  for (const auto& [number, type] : known) number_of[number] = type;
  const auto spans = SpansOf(contents);
  ASSERT_EQ(contents.remarks.size(), 1U);
  for (const auto& [number, count] : reference["counts_by_message_id"].items()) {
    SCOPED_TRACE(number);
    if (number_of.contains(number)) {
      ASSERT_TRUE(spans.contains(number_of[number]));
      EXPECT_EQ(spans.at(number_of[number]).count, count.get<std::uint64_t>());
    } else {
      EXPECT_NE(contents.remarks[0].find(
                    fmt::format("message {}: {}", number, count.get<std::uint64_t>())),
                std::string::npos)
          << contents.remarks[0];
    }
  }
  EXPECT_EQ(spans.size(), number_of.size());
  for (const char* end : {"first", "last"}) {
    for (const auto& [type, values] : reference[end].items()) {
      if (!spans.contains(type)) continue;
      SCOPED_TRACE(type);
      Selection selection;
      for (const auto& [field, value] : values.items()) {
        if (field != "stamp_us") selection.fields.push_back(field);
      }
      // Of several senders one has it.
      bool is_there = false;
      for (const Channel& channel : contents.channels) {
        if (channel.type != type) continue;
        selection.channel = channel.name;
        recording->Read(
            {&selection, 1}, [&](std::size_t, double time, std::span<const double> row) {
              if (std::abs(time - 1e-6 * values["stamp_us"].get<double>()) > 3e-7) return;
              bool is_same = true;
              for (std::size_t i = 0; i < row.size(); ++i) {
                is_same = is_same && row[i] == values[selection.fields[i]].get<double>();
              }
              is_there = is_there || is_same;
            });
      }
      EXPECT_TRUE(is_there);
    }
  }
}

// Topics of a reference by name, with type, count, first and last stamp.
void ExpectTopics(const Contents& contents, const Json& topics) {
  EXPECT_EQ(contents.channels.size(), topics.size());
  for (const Json& topic : topics) {
    const std::string name = topic["topic"];
    SCOPED_TRACE(name);
    const auto channel = std::find_if(contents.channels.begin(),
                                      contents.channels.end(),
                                      [&](const Channel& c) { return c.name == name; });
    ASSERT_NE(channel, contents.channels.end());
    EXPECT_EQ(channel->type, topic["type"].get<std::string>());
    EXPECT_EQ(channel->count, topic["count"].get<std::uint64_t>());
    EXPECT_FALSE(channel->fields.empty());
    // Stamps of 1e9 s are doubles with steps of 2.4e-7 s.
    const auto stamp = [&](const char* seconds, const char* log_time, const char* nanoseconds) {
      if (topic.contains(seconds)) return std::stod(topic[seconds].get<std::string>());
      const char* key = topic.contains(log_time) ? log_time : nanoseconds;
      return static_cast<double>(topic[key].get<std::int64_t>()) * 1e-9;
    };
    EXPECT_NEAR(*channel->first, stamp("first", "first_log_time_ns", "first_ns"), 3e-7);
    EXPECT_NEAR(*channel->last, stamp("last", "last_log_time_ns", "last_ns"), 3e-7);
  }
}

TEST_F(RealRecordings, BagsHoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats" / "bags";
  const Json references = ReadJson(folder / "reference.json");
  EXPECT_EQ(references.size(), 22U);
  for (const auto& [name, reference] : references.items()) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(folder / name);
    EXPECT_TRUE(recording->contents().IsComplete());
    ExpectTopics(recording->contents(), reference["topics"]);
  }
}

TEST_F(RealRecordings, FilesOfRosHoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats";
  const Json references = ReadJson(folder / "reference.json");
  for (const char* name : {"evo_ros1_example.bag",
                           "evo_ros1_tf.bag",
                           "usv_sim_sines.bag",
                           "evo_nav2_turtlebot.mcap",
                           "rosbag2_cdr_test_0.mcap",
                           "rosbag2_cdr_test_0.db3",
                           "evo_rosbag2_tf/tf_example.db3"}) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(folder / name);
    EXPECT_TRUE(recording->contents().IsComplete());
    ExpectTopics(recording->contents(), references[name]["topics"]);
  }
}

// First and last values of each pose topic, as another decoder found them.
TEST_F(RealRecordings, PosesOfABagAreThoseOfItsReference) {
  const std::filesystem::path folder = folder_ / "formats";
  const Json references = ReadJson(folder / "reference.json");
  const auto recording = OpenRecording(folder / "evo_ros1_example.bag");
  for (const Json& topic : references["evo_ros1_example.bag"]["topics"]) {
    const Selection selection = {topic["topic"],
                                 {"header.stamp",
                                  "pose.position.x",
                                  "pose.position.y",
                                  "pose.position.z",
                                  "pose.orientation.w"}};
    std::vector<std::vector<double>> rows;
    recording->Read({&selection, 1}, [&](std::size_t, double, std::span<const double> values) {
      rows.emplace_back(values.begin(), values.end());
    });
    for (const auto& [key, row] :
         {std::pair("first_message", rows.front()), std::pair("last_message", rows.back())}) {
      const Json& message = topic[key];
      EXPECT_NEAR(row[0], std::stod(message["header_stamp"].get<std::string>()), 3e-7);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(row[1 + i], message["position"][i].get<double>(), 1e-9);
      EXPECT_NEAR(row[4], message["orientation_xyzw"][3].get<double>(), 1e-9);
    }
  }
}

TEST_F(RealRecordings, BagsOfSoniaHoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "sonia";
  const Json references = ReadJson(folder / "reference.json");
  int num_bags = 0;
  for (const auto& [name, reference] : references.items()) {
    if (!name.ends_with(".bag")) continue;
    SCOPED_TRACE(name);
    ++num_bags;
    const auto recording = OpenRecording(folder / name);
    const Contents& contents = recording->contents();
    EXPECT_EQ(contents.channels.size(), reference["topics"].size());
    for (const Channel& channel : contents.channels) {
      EXPECT_EQ(channel.type, reference["topics"][channel.name]["type"].get<std::string>());
      EXPECT_EQ(channel.count, reference["topics"][channel.name]["count"].get<std::uint64_t>());
    }
  }
  EXPECT_EQ(num_bags, 3);
}

TEST_F(RealRecordings, LogsOfRockHoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats" / "pocolog";
  const Json references = ReadJson(folder / "reference.json");
  EXPECT_EQ(references.size(), 8U);
  for (const auto& [name, reference] : references.items()) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(folder / name);
    const Contents& contents = recording->contents();
    EXPECT_TRUE(contents.IsComplete());
    EXPECT_EQ(contents.channels.size(), reference["streams"].size());
    for (const Json& stream : reference["streams"]) {
      const Channel channel = ChannelNamed(contents, stream["name"]);
      EXPECT_EQ(channel.type, stream["type"].get<std::string>());
      EXPECT_EQ(channel.count, stream["count"].get<std::uint64_t>());
      if (stream["first"].is_null()) continue;
      EXPECT_NEAR(*channel.first, stream["first"].get<double>(), 3e-7);
      EXPECT_NEAR(*channel.last, stream["last"].get<double>(), 3e-7);
      EXPECT_FALSE(channel.fields.empty());
    }
  }
}

// The numbers of a table of the real data, without its header.
std::vector<std::vector<double>> RowsOf(const std::filesystem::path& file) {
  std::vector<std::vector<double>> rows;
  std::ifstream lines(file);
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(std::move(row));
  }
  return rows;
}

// The method's own author's logs, of the folder as one recording, give the log that was made from
// them by others: from z up to z down, and without the first row, which is NaN.
TEST_F(RealRecordings, LogsOfRockGiveTheAuthorsLog) {
  constexpr const char* kMap = R"(
dof: surge
command:
  channel: "/forces&torques.forces"
  frame: FLU
  time: time
  tau_surge: {field: "elements[0].effort", unit: N}
  tau_sway: {field: "elements[1].effort", unit: N}
  tau_heave: {field: "elements[2].effort", unit: N}
  tau_roll: {field: "elements[3].effort", unit: Nm}
  tau_pitch: {field: "elements[4].effort", unit: Nm}
  tau_yaw: {field: "elements[5].effort", unit: Nm}
velocity:
  channel: /adap_samples.velocity
  frame: FLU
  time: time
  u: "velocity.data[0]"
  v: "velocity.data[1]"
  w: "velocity.data[2]"
  p: "angular_velocity.data[0]"
  q: "angular_velocity.data[1]"
  r: "angular_velocity.data[2]"
pose:
  channel: /adap_samples.dynamic
  frame: NWU
  time: rbs.time
  x: "rbs.position.data[0]"
  y: "rbs.position.data[1]"
  z: "rbs.position.data[2]"
  qx: "rbs.orientation.im[0]"
  qy: "rbs.orientation.im[1]"
  qz: "rbs.orientation.im[2]"
  qw: "rbs.orientation.re"
)";
  const std::filesystem::path folder = folder_ / "formats" / "pocolog";
  const auto recording = OpenRecording(folder);
  const Log log = ImportLog(folder, *recording, ParseImportMap("map.yaml", kMap), std::nullopt).log;
  const auto expect_equal = [&](const Stream& stream, const char* file, int num_columns) {
    SCOPED_TRACE(file);
    const auto rows = RowsOf(folder_ / "lbv_surge" / file);
    ASSERT_EQ(stream.time.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(stream.time[i], rows[i][0], 6e-7);
      for (int k = 0; k < num_columns; ++k) {
        const double expected = rows[i][1 + k];
        EXPECT_NEAR(stream.values[k][i], expected, 1e-9 * std::max(1.0, std::abs(expected)));
      }
    }
  };
  ASSERT_TRUE(log.command && log.velocity && log.pose);
  expect_equal(*log.command, "command.csv", 6);
  expect_equal(*log.velocity, "author_velocity.csv", 6);
  expect_equal(*log.pose, "pose.csv", 7);
}

}  // namespace
}  // namespace fathom
