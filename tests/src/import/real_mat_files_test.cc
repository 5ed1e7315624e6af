// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// .mat files of others, held against what other decoders found in them.

#include "fathom/import/open_recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "real_data.h"
#include "scratch_file.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using RealMatFiles = OnRealData;
using Json = nlohmann::json;

Json JsonOfFile(const std::filesystem::path& path) { return Json::parse(std::ifstream(path)); }

// The samples of all fields.
ReadSamples AllOfChannel(const Recording& recording, const std::string& name) {
  Selection selection = {name, {}};
  for (const Field& field : ChannelNamed(recording.contents(), name).fields) {
    selection.fields.push_back(field.name);
  }
  return ReadAll(recording, selection);
}

TEST_F(RealMatFiles, ShipModelsOfVersion4HoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats" / "mat";
  const Json references = JsonOfFile(folder / "reference.json");
  for (const auto& [name, reference] : references.items()) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(folder / name);
    EXPECT_TRUE(recording->contents().IsComplete());
    EXPECT_EQ(recording->contents().format, "mat4");
    EXPECT_EQ(recording->contents().channels.size(), reference["variables"].size());
    for (const auto& [variable, expected] : reference["variables"].items()) {
      const ReadSamples samples = AllOfChannel(*recording, variable);
      ASSERT_EQ(samples.rows.size(), expected["shape"][1].get<std::size_t>());
      EXPECT_EQ(samples.rows.front(), expected["first_column"].get<std::vector<double>>());
      EXPECT_EQ(samples.rows.back(), expected["last_column"].get<std::vector<double>>());
      for (std::size_t k = 0; k < samples.rows.front().size(); ++k) {
        double sum = 0.0;
        for (const auto& row : samples.rows) sum += row[k];
        // The other decoder added in another order.
        EXPECT_NEAR(sum, expected["row_sum"][k].get<double>(), 1e-9 * samples.rows.size() * 400.0);
      }
    }
  }
}

TEST_F(RealMatFiles, AMotorOfVersion5HoldsWhatItsReferenceSays) {
  const std::filesystem::path folder = folder_ / "formats";
  const Json reference = JsonOfFile(folder / "reference.json")["matlab_v5.mat"];
  const auto recording = OpenRecording(folder / "matlab_v5.mat");
  EXPECT_TRUE(recording->contents().IsComplete());
  for (const auto& [name, expected] : reference.items()) {
    if (!expected.is_object()) continue;
    SCOPED_TRACE(name);
    const ReadSamples samples = ReadAll(*recording, {name, {"value"}});
    ASSERT_EQ(samples.rows.size(), expected["shape"][0].get<std::size_t>());
    std::vector<double> values;
    for (const auto& row : samples.rows) values.push_back(row.front());
    EXPECT_EQ(values.front(), expected["first"].get<double>());
    EXPECT_EQ(values.back(), expected["last"].get<double>());
    EXPECT_EQ(*std::min_element(values.begin(), values.end()), expected["min"].get<double>());
    EXPECT_EQ(*std::max_element(values.begin(), values.end()), expected["max"].get<double>());
  }
}

TEST_F(RealMatFiles, AFileOfVersion73HoldsWhatItsReferenceSays) {
  const auto recording = OpenRecording(folder_ / "formats" / "matlab_v73.mat");
  const ReadSamples samples = ReadAll(*recording, {"testdouble", {"value"}});
  ASSERT_EQ(samples.rows.size(), 9U);
  for (int k = 0; k < 9; ++k) EXPECT_NEAR(samples.rows[k][0], k * std::numbers::pi / 4.0, 1e-15);
}

TEST_F(RealMatFiles, RunsOfSoniaHoldWhatTheirReferenceSays) {
  const std::filesystem::path folder = folder_ / "sonia";
  const Json references = JsonOfFile(folder / "reference.json");
  int num_files = 0;
  for (const auto& [name, reference] : references.items()) {
    if (!name.ends_with(".mat")) continue;
    SCOPED_TRACE(name);
    ++num_files;
    const auto recording = OpenRecording(folder / name);
    EXPECT_TRUE(recording->contents().IsComplete());
    EXPECT_EQ(recording->contents().channels.size(), reference.size());
    for (const auto& [array, expected] : reference.items()) {
      SCOPED_TRACE(array);
      const ReadSamples samples = AllOfChannel(*recording, array);
      ASSERT_EQ(samples.rows.size(), expected["shape"][0].get<std::size_t>());
      EXPECT_EQ(samples.rows.front(), expected["first"].get<std::vector<double>>());
      EXPECT_EQ(samples.rows.back(), expected["last"].get<std::vector<double>>());
      for (std::size_t k = 0; k < samples.rows.front().size(); ++k) {
        double squares = 0.0;
        for (const auto& row : samples.rows) squares += row[k] * row[k];
        // Six digits are given.
        EXPECT_NEAR(
            std::sqrt(squares / samples.rows.size()), expected["rms"][k].get<double>(), 6e-7);
      }
    }
  }
  EXPECT_EQ(num_files, 11);
}

// The authors wrote the values of the bag into the .mat, to the last bit.
TEST_F(RealMatFiles, ARunOfSoniaIsThatOfItsBag) {
  const std::filesystem::path folder = folder_ / "sonia";
  const auto mat = OpenRecording(folder / "y_10_1.mat");
  const auto bag = OpenRecording(folder / "y_10_2017-12-09-19-55-04.bag");
  for (const auto& [array, topic, part] :
       {std::array{"LINEAR_SPEED", "/provider_dvl/dvl_twist", "linear"},
        std::array{"ANGULAR_SPEED", "/provider_imu/twist", "angular"}}) {
    SCOPED_TRACE(array);
    std::string prefix;
    for (const Field& field : ChannelNamed(bag->contents(), topic).fields) {
      const std::size_t at = field.name.find(std::string(part) + ".x");
      if (at != std::string::npos) prefix = field.name.substr(0, at) + part;
    }
    const ReadSamples of_mat = ReadAll(*mat, {array, {"1", "2", "3"}});
    const ReadSamples of_bag =
        ReadAll(*bag, {topic, {prefix + ".x", prefix + ".y", prefix + ".z"}});
    EXPECT_EQ(of_mat.rows, of_bag.rows);
  }
}

}  // namespace
}  // namespace fathom
