// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Files that the formats' own software writes, held to the bit against what it was given: rosbag
// for bags, @mcap/core for MCAP, scipy and h5py for .mat. The programs in writers/ write them into
// a folder, with an expected.json that says what is in them.

#include "fathom/import/open_recording.h"
#include "fathom/process/run_child.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "scratch_file.h"
#include "test_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

namespace fs = std::filesystem;

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAreArray;

constexpr int kSoftwareIsMissing = 77;  // a writer's exit code

std::vector<std::string> NamesOf(const nlohmann::json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

bool IsSame(const nlohmann::json& expected, double value) {
  return expected.is_null() ? std::isnan(value) : expected.get<double>() == value;
}

void ExpectChannel(const Recording& recording,
                   const Channel& channel,
                   const nlohmann::json& expected) {
  SCOPED_TRACE(channel.name);
  const nlohmann::json& time = expected.at("time");
  EXPECT_EQ(channel.type, expected.at("type").get<std::string>());
  EXPECT_EQ(channel.count, time.size());
  std::vector<std::string> fields;
  for (const Field& field : channel.fields) fields.push_back(field.name);
  ASSERT_THAT(fields, UnorderedElementsAreArray(NamesOf(expected.at("fields"))));
  if (fields.empty()) return;
  const ReadSamples samples = ReadAll(recording, {channel.name, fields});
  ASSERT_EQ(samples.rows.size(), time.size());
  for (std::size_t k = 0; k < samples.rows.size(); ++k) {
    ASSERT_TRUE(IsSame(time[k], samples.time[k])) << k << ": " << samples.time[k];
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const nlohmann::json& value = expected["fields"][fields[i]][k];
      ASSERT_TRUE(IsSame(value, samples.rows[k][i]))
          << fields[i] << " of sample " << k << ": " << samples.rows[k][i] << ", not " << value;
    }
  }
}

void ExpectRecording(const fs::path& path, const nlohmann::json& expected) {
  const auto recording = OpenRecording(path);
  const Contents& contents = recording->contents();
  EXPECT_EQ(contents.format, expected.at("format").get<std::string>());
  EXPECT_TRUE(contents.IsComplete());
  std::vector<std::string> names;
  for (const Channel& channel : contents.channels) names.push_back(channel.name);
  EXPECT_THAT(names, UnorderedElementsAreArray(NamesOf(expected.at("channels"))));
  for (const Channel& channel : contents.channels) {
    if (!expected["channels"].contains(channel.name)) continue;
    ExpectChannel(*recording, channel, expected["channels"][channel.name]);
  }
  for (const auto& remark : expected.at("remarks")) {
    EXPECT_THAT(contents.remarks, Contains(HasSubstr(remark.get<std::string>())));
  }
  if (expected.at("remarks").empty()) {
    EXPECT_THAT(contents.remarks, IsEmpty());
  }
}

// A program of writers/, by name, and what it needs.
struct FormatWriter {
  const char* program;
  const char* software;
};

void PrintTo(const FormatWriter& writer, std::ostream* out) { *out << writer.program; }

class RoundTrip : public ::testing::TestWithParam<FormatWriter> {};

TEST_P(RoundTrip, DeliversWhatWasWritten) {
  const fs::path folder = EmptyTestFolder();
  const fs::path writers = fs::path(FATHOM_SOURCE_DIR) / "tests" / "src" / "import" / "writers";
  const fs::path program = writers / GetParam().program;
  ASSERT_TRUE(fs::exists(program));
  const ChildResult run = RunChild({.program = program.string(), .arguments = {folder.string()}});
  // Without an interpreter it does not start, or env says so by 127.
  if (run.end == ChildEnd::kNotStarted || run.exit_code == 127 ||
      run.exit_code == kSoftwareIsMissing) {
    GTEST_SKIP() << GetParam().program << " needs " << GetParam().software << ": " << run.err;
  }
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::ifstream file(folder / "expected.json");
  const auto expected = nlohmann::json::parse(file);
  ASSERT_FALSE(expected.empty());
  for (const auto& item : expected.items()) {
    SCOPED_TRACE(item.key());
    ExpectRecording(folder / item.key(), item.value());
  }
  fs::remove_all(folder);
}

constexpr FormatWriter kWriters[] = {
    {"write_bags.py", "Debian's python3-rosbag, python3-nav-msgs and python3-sensor-msgs"},
    {"write_mats.py", "Debian's python3-scipy and python3-h5py"},
    {"write_mcaps.mjs", "Node.js and its packages, scripts/install_dependencies.sh"},
};

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, ::testing::ValuesIn(kWriters));

}  // namespace
}  // namespace fathom
