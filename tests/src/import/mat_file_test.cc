// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// .mat files that scipy and h5py wrote: fuzz/corpus/matlab, by scripts/write_mat_files.py.

#include "fathom/base/random_stream.h"
#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/map_by_names.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

// The HDF5 library does not free all that it took for some damaged files.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsNan;

const char* const kMatFiles[] = {
    "little_4.mat", "big_4.mat", "plain_5.mat", "compressed_5.mat", "big_5.mat", "hdf5_73.mat"};

std::filesystem::path MatPath(const std::string& name) {
  return std::filesystem::path(FATHOM_SOURCE_DIR) / "fuzz" / "corpus" / "matlab" / name;
}

std::string MatBytes(const std::string& name) {
  std::ifstream file(MatPath(name), std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

// Row k is k, k + 0.25, -k.
void ExpectEta(const Recording& recording, const std::string& channel, double offset = 0.0) {
  const ReadSamples samples = ReadAll(recording, {channel, {"1", "2", "3"}});
  ASSERT_EQ(samples.rows.size(), 12U) << channel;
  EXPECT_THAT(samples.time, Each(IsNan()));
  for (int k = 0; k < 12; ++k) {
    EXPECT_THAT(samples.rows[k], ElementsAre(k + offset, k + 0.25 + offset, -k + offset));
  }
}

TEST(MatFile, ReadsTheSameArrayOfEveryVersion) {
  for (const char* name : kMatFiles) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(MatPath(name));
    EXPECT_TRUE(recording->contents().IsComplete());
    const Channel eta = ChannelNamed(recording->contents(), "eta");
    EXPECT_EQ(eta.type, "double 12x3");
    EXPECT_EQ(eta.count, 12U);
    EXPECT_FALSE(eta.first.has_value());
    ExpectEta(*recording, "eta");
  }
  EXPECT_EQ(OpenRecording(MatPath("big_4.mat"))->contents().format, "mat4");
  EXPECT_EQ(OpenRecording(MatPath("big_5.mat"))->contents().format, "mat5");
  EXPECT_EQ(OpenRecording(MatPath("hdf5_73.mat"))->contents().format, "mat7.3");
}

TEST(MatFile, TakesTheLongerDimensionAsTime) {
  for (const char* name : {"little_4.mat", "big_4.mat", "plain_5.mat", "compressed_5.mat"}) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(MatPath(name));
    EXPECT_THAT(ChannelNamed(recording->contents(), "wide").type, HasSubstr(" 3x12"));
    ExpectEta(*recording, "wide");
  }
}

TEST(MatFile, ReadsEveryClassOfNumbers) {
  for (const char* name : {"plain_5.mat", "compressed_5.mat"}) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(MatPath(name));
    EXPECT_EQ(ChannelNamed(recording->contents(), "counts").type, "int16 12x1");
    EXPECT_EQ(ReadAll(*recording, {"counts", {"value"}}).rows[7][0], 7.0);
    EXPECT_EQ(ChannelNamed(recording->contents(), "flags").type, "logical 12x1");
    EXPECT_EQ(ReadAll(*recording, {"flags", {"value"}}).rows[5][0], 0.0);
    EXPECT_EQ(ReadAll(*recording, {"flags", {"value"}}).rows[6][0], 1.0);
    EXPECT_EQ(ReadAll(*recording, {"big", {"value"}}).rows[1][0], 1099511627776.0);
  }
  EXPECT_EQ(ReadAll(*OpenRecording(MatPath("hdf5_73.mat")), {"counts", {"value"}}).rows[7][0], 7);
  ExpectEta(*OpenRecording(MatPath("hdf5_73.mat")), "packed");
}

TEST(MatFile, GivesAStructItsStamps) {
  for (const char* name : {"plain_5.mat", "compressed_5.mat", "hdf5_73.mat"}) {
    SCOPED_TRACE(name);
    const auto recording = OpenRecording(MatPath(name));
    const Channel run = ChannelNamed(recording->contents(), "run");
    EXPECT_EQ(run.type, "struct");
    EXPECT_EQ(run.first, 0.0);
    EXPECT_DOUBLE_EQ(*run.last, 1.1);
    const ReadSamples samples = ReadAll(*recording, {"run", {"eta.2", "t"}});
    EXPECT_DOUBLE_EQ(samples.time[4], 0.4);
    EXPECT_THAT(samples.rows[4], ElementsAre(4.25, samples.time[4]));
  }
  const auto recording = OpenRecording(MatPath("plain_5.mat"));
  EXPECT_EQ(ChannelNamed(recording->contents(), "run.short").count, 5U);
}

TEST(MatFile, NumbersStructsAndCellsFromOne) {
  const auto recording = OpenRecording(MatPath("compressed_5.mat"));
  ExpectEta(*recording, "runs[1].eta");
  ExpectEta(*recording, "runs[2].eta", 100.0);
  EXPECT_EQ(ReadAll(*recording, {"cells[1]", {"value"}}).rows[11][0], 1.1);
  EXPECT_EQ(ReadAll(*OpenRecording(MatPath("hdf5_73.mat")), {"cells[1]", {"value"}}).rows[11][0],
            1.1);
}

TEST(MatFile, TellsWhatItPassesOver) {
  const auto recording = OpenRecording(MatPath("plain_5.mat"));
  EXPECT_THAT(recording->contents().remarks,
              AllOf(Contains("'z' is complex: passed over."),
                    Contains("'cube' has 3 dimensions: passed over."),
                    Contains(HasSubstr("sl is a 'structure with time' of Simulink")),
                    Contains("no channels: 1 scalar, 5 texts, 1 empty array.")));
}

TEST(MatFile, NamesTheFormatsThereAre) {
  const auto path = ScratchFile("x.mat", std::string("\x01\x02\x03\x04", 4));
  EXPECT_THAT(ErrorFrom([&] { OpenRecording(path); }), HasSubstr("a .mat of MATLAB"));
  const auto cut = ScratchFile("y.mat", MatBytes("plain_5.mat").substr(0, 100));
  EXPECT_THAT(ErrorFrom([&] { OpenRecording(cut); }),
              HasSubstr("ends at byte 100, expected the header of a .mat of 128 bytes"));
}

TEST(MatFile, TellsWhereACutFileEnds) {
  const std::string all = MatBytes("plain_5.mat");
  // eta comes first: 128 bytes of header, then its tag, its parts and 288 bytes of numbers.
  const auto recording = OpenRecording(ScratchFile("cut.mat", all.substr(0, 600)));
  const Contents& contents = recording->contents();
  EXPECT_FALSE(contents.IsComplete());
  ExpectEta(*recording, "eta");
  EXPECT_THAT(contents.remarks,
              Contains(HasSubstr("bytes from byte " + std::to_string(contents.read_bytes))));
}

// Peak of the whole program [MB]; 0 where the sanitizer holds back what is freed.
double PeakMemory() {
#if defined(__SANITIZE_ADDRESS__)
  return 0.0;
#else
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
#endif
}

// Lists and reads a file whatever it holds. Nothing but an InputError may come of it.
void ReadWhatThereIs(const std::string& bytes) {
  ErrorFrom([&] {
    const auto recording = OpenRecording(ScratchFile("damaged.mat", bytes));
    const Contents& contents = recording->contents();
    EXPECT_LE(contents.read_bytes, contents.size_bytes);
    for (const Channel& channel : contents.channels) {
      EXPECT_LE(channel.count, 100000U);
      ReadAll(*recording, {channel.name, {channel.fields.front().name}});
    }
  });
}

// Of a file that is cut anywhere, every variable before the cut is there.
TEST(MatFile, DeliversAllBeforeACut) {
  RandomStream random(1, "cuts");
  for (const char* name : kMatFiles) {
    SCOPED_TRACE(name);
    const std::string all = MatBytes(name);
    const auto whole = OpenRecording(MatPath(name));
    for (int trial = 0; trial < 100; ++trial) {
      const auto length = static_cast<std::size_t>(random.Uniform() * all.size());
      ReadWhatThereIs(all.substr(0, length));
    }
  }
  // Version 4: its variables end at bytes 312, 481 and 532.
  const std::string all = MatBytes("little_4.mat");
  for (std::size_t length = 312; length < all.size(); ++length) {
    const auto recording = OpenRecording(ScratchFile("cut.mat", all.substr(0, length)));
    ExpectEta(*recording, "eta");
    EXPECT_EQ(recording->contents().read_bytes, length < 481 ? 312U : 481U);
    EXPECT_EQ(recording->contents().channels.size(), length < 481 ? 1U : 2U);
  }
}

TEST(MatFile, SurvivesFlippedBits) {
  RandomStream random(2, "flips");
  for (const char* name : kMatFiles) {
    SCOPED_TRACE(name);
    const std::string all = MatBytes(name);
    for (int trial = 0; trial < 100; ++trial) {
      std::string flipped = all;
      for (int k = 0; k < 5; ++k) {
        const auto at = static_cast<std::size_t>(random.Uniform() * flipped.size());
        flipped[at] =
            static_cast<char>(flipped[at] ^ (1 << static_cast<int>(8 * random.Uniform())));
      }
      ReadWhatThereIs(flipped);
    }
  }
  EXPECT_LT(PeakMemory(), 300.0);
}

TEST(MatFile, BelievesNoSizeThatTheFileDoesNotHold) {
  std::string wide = MatBytes("little_4.mat");
  for (const int at : {4, 8}) wide.replace(at, 4, std::string("\xff\xff\xff\x7f", 4));
  const auto recording = OpenRecording(ScratchFile("wide.mat", wide));
  EXPECT_THAT(recording->contents().channels, IsEmpty());
  EXPECT_EQ(recording->contents().read_bytes, 0U);
  EXPECT_LT(PeakMemory(), 300.0);
}

// The HDF5 library would inflate it as far as it goes.
TEST(MatFile, InflatesNoChunkBeyondItsSize) {
  const auto recording = OpenRecording(MatPath("bomb_73.mat"));
  EXPECT_THAT(ErrorFrom([&] {
                ReadAll(*recording, {"eta", {"value"}});
              }),
              HasSubstr("eta is damaged, expected 1 x 3 numbers."));
}

// What a map makes of a file of the corpus.
ImportedLog ImportMat(const std::string& name, const std::string& map) {
  const auto recording = OpenRecording(MatPath(name));
  return ImportLog(
      MatPath(name), *recording, ParseImportMap("map.yaml", "dof: surge\n" + map), std::nullopt);
}

TEST(MatFile, ImportsArraysWithoutStampsByARate) {
  const Log log =
      ImportMat("little_4.mat", "velocity: {channel: eta, rate: 5, delay: 1, u: 1, v: 2}").log;
  EXPECT_EQ(log.velocity->time[3], 1.6);
  EXPECT_EQ(log.velocity->values[1][3], 3.25);
  EXPECT_THAT(ErrorFrom([] { ImportMat("little_4.mat", "velocity: {channel: eta, u: 1}"); }),
              HasSubstr("eta has no stamps, expected the map to give its 'rate' in Hz"));
}

TEST(MatFile, TakesTheStampsFromAnotherArray) {
  const Log log =
      ImportMat("plain_5.mat",
                "velocity: {channel: sl.signals.values, time: {channel: sl.time, field: "
                "value, unit: s}, delay: 1, u: 1, v: 2}")
          .log;
  EXPECT_EQ(log.velocity->time.size(), 12U);
  EXPECT_DOUBLE_EQ(log.velocity->time[3], 1.3);
  EXPECT_EQ(log.velocity->values[1][3], 3.25);
}

TEST(MatFile, TakesTheStampsOfTheRowsThatAreTaken) {
  const Log log =
      ImportMat("plain_5.mat",
                "velocity: {channel: flags, where: {value: 1}, time: {channel: sl.time, "
                "field: value}, u: value}")
          .log;
  EXPECT_EQ(log.velocity->time.size(), 6U);
  EXPECT_DOUBLE_EQ(log.velocity->time[0], 0.6);
}

TEST(MatFile, TakesTheStampsFromARowOfTheSameArray) {
  const Log log = ImportMat("plain_5.mat", "velocity: {channel: eta, time: 1, u: 2}").log;
  EXPECT_EQ(log.velocity->time[3], 3.0);
  EXPECT_EQ(log.velocity->values[0][3], 3.25);
}

// An array of a .mat with so many samples and columns.
Channel ArrayChannel(const std::string& name, std::uint64_t count, int num_columns) {
  Channel channel;
  channel.name = name;
  channel.count = count;
  for (int i = 1; i <= num_columns; ++i) {
    channel.fields.push_back({num_columns == 1 ? "value" : std::to_string(i), "", i});
  }
  return channel;
}

Contents MatContents(std::vector<Channel> channels) {
  Contents contents;
  contents.format = "mat5";
  contents.channels = std::move(channels);
  return contents;
}

TEST(MatFile, SuggestsARateWhereThereAreNoStamps) {
  const std::string map =
      MapByNames(MatContents({ArrayChannel("Thrust", 9, 6), ArrayChannel("nu", 8, 6)})).text;
  EXPECT_THAT(map, HasSubstr("channel: Thrust\n  rate: 10  # Hz: there are no stamps."));
  EXPECT_THAT(map, HasSubstr("tau_yaw: {field: \"6\", unit: N m}"));
  EXPECT_THAT(map, HasSubstr("channel: nu\n  rate: 10"));
  EXPECT_THAT(map, HasSubstr("v: {field: \"2\", unit: m/s}"));
  EXPECT_THAT(map, HasSubstr("r: {field: \"6\", unit: rad/s}"));
}

TEST(MatFile, SuggestsStampsAndChannelsOfColumns) {
  const std::string map = MapByNames(MatContents({ArrayChannel("force", 9, 1),
                                                  ArrayChannel("t", 9, 1),
                                                  ArrayChannel("u", 9, 1),
                                                  ArrayChannel("yawrate", 9, 1)}))
                              .text;
  EXPECT_THAT(map, HasSubstr("  channel: force\n  time: {channel: t, field: value, unit: s}"));
  EXPECT_THAT(map, HasSubstr("tau_surge: {field: value, unit: N}"));
  EXPECT_THAT(map, HasSubstr("u: {field: value, unit: m/s}"));
  EXPECT_THAT(map, HasSubstr("r: {channel: yawrate, field: value, unit: rad/s}"));
}

TEST(MatFile, SuggestsTheVectorsOfAStruct) {
  Channel run;
  run.name = "run";
  run.first = 0.0;
  for (int i = 1; i <= 6; ++i) run.fields.push_back({"eta." + std::to_string(i), "", i});
  EXPECT_THAT(
      MapByNames(MatContents({run})).text,
      AllOf(HasSubstr("x: {field: eta.1, unit: m}"), HasSubstr("yaw: {field: eta.6, unit: rad}")));
}

TEST(MatFile, RefusesStampsOfAnotherNumber) {
  EXPECT_THAT(ErrorFrom([] {
                ImportMat("plain_5.mat",
                          "velocity: {channel: eta, time: {channel: big, field: value}, u: 1}");
              }),
              HasSubstr("big holds 2 stamps, expected as many as eta has samples: 12."));
}

// 7.25 stands in sample 8 of the second column.
TEST(MatFile, TellsHowManyNumbersAreMissing) {
  const double number = 7.25;
  const double missing = std::nan("");
  const std::string from(reinterpret_cast<const char*>(&number), sizeof(number));
  const std::string to(reinterpret_cast<const char*>(&missing), sizeof(missing));
  for (const char* name : {"little_4.mat", "plain_5.mat", "hdf5_73.mat"}) {
    SCOPED_TRACE(name);
    std::string bytes = MatBytes(name);
    for (std::size_t at = 0; (at = bytes.find(from, at)) != std::string::npos;) {
      bytes.replace(at, to.size(), to);
    }
    EXPECT_THAT(OpenRecording(ScratchFile(name, bytes))->contents().remarks,
                Contains("eta: 1 number missing, NaN or infinite, the first is sample 8 of '2'."));
  }
}

TEST(MatFile, SaysWhyAChannelMayBeMissing) {
  const std::string bytes = MatBytes("plain_5.mat");
  const auto recording = OpenRecording(ScratchFile("cut.mat", bytes.substr(0, bytes.size() / 2)));
  ASSERT_FALSE(recording->contents().IsComplete());
  EXPECT_THAT(ErrorFrom([&] {
                ReadAll(*recording, {"none", {"value"}});
              }),
              AllOf(HasSubstr("holds no channel 'none', expected one of "),
                    HasSubstr("Not all of the file is read: the file ends within a variable")));
}

}  // namespace
}  // namespace fathom
