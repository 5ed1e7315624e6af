// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Files that numpy wrote: fuzz/corpus/numpy, by scripts/write_npy_files.py.

#include "fathom/base/input_error.h"
#include "fathom/base/random_stream.h"
#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsNan;

std::filesystem::path NumpyPath(const std::string& name) {
  return std::filesystem::path(FATHOM_SOURCE_DIR) / "fuzz" / "corpus" / "numpy" / name;
}

std::string NumpyBytes(const std::string& name) {
  std::ifstream file(NumpyPath(name), std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

// Row k is k, k + 0.25, -k.
void ExpectNumpyEta(const Recording& recording, const std::string& channel) {
  SCOPED_TRACE(channel);
  const ReadSamples samples = ReadAll(recording, {channel, {"1", "2", "3"}});
  ASSERT_EQ(samples.rows.size(), 12U);
  EXPECT_THAT(samples.time, Each(IsNan()));
  for (int k = 0; k < 12; ++k) EXPECT_THAT(samples.rows[k], ElementsAre(k, k + 0.25, -k));
}

// A .npy of version 1.
std::string Npy(const std::string& header, const std::string& elements) {
  const auto size = static_cast<unsigned>(header.size());
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(size & 255U) +
         static_cast<char>(size >> 8U) + header + elements;
}

TEST(NumpyFile, ReadsAnArrayOfEveryVersionOfTheHeader) {
  for (const char* name : {"eta", "version_2", "version_3"}) {
    const auto recording = OpenRecording(NumpyPath(std::string(name) + ".npy"));
    EXPECT_TRUE(recording->contents().IsComplete());
    EXPECT_EQ(recording->contents().format, "npy");
    const Channel channel = ChannelNamed(recording->contents(), name);
    EXPECT_EQ(channel.type, "array 12x3");
    EXPECT_EQ(channel.count, 12U);
    ExpectNumpyEta(*recording, name);
  }
}

TEST(NumpyFile, ReadsAnArrayInEveryOrderOfItsElements) {
  for (const char* name : {"stored.npz", "packed.npz"}) {
    const auto recording = OpenRecording(NumpyPath(name));
    EXPECT_EQ(recording->contents().format, "npz");
    EXPECT_TRUE(recording->contents().IsComplete());
    for (const char* channel : {"eta", "wide", "fortran", "wide_fortran", "big", "thin"}) {
      ExpectNumpyEta(*recording, channel);
    }
  }
}

TEST(NumpyFile, ReadsEveryTypeOfNumbers) {
  const auto recording = OpenRecording(NumpyPath("packed.npz"));
  for (const char* type : {"i1", "i2", ">i4", "i8", "u1", ">u2", "u4", ">u8", "<f4", ">f8"}) {
    const std::string name = std::string("of_") + type;
    const ReadSamples samples = ReadAll(*recording, {name, {"value"}});
    ASSERT_EQ(samples.rows.size(), 12U) << name;
    EXPECT_EQ(samples.rows[11][0], 11.0) << name;
  }
  EXPECT_EQ(ReadAll(*recording, {"flags", {"value"}}).rows[5][0], 0.0);
  EXPECT_EQ(ReadAll(*recording, {"flags", {"value"}}).rows[6][0], 1.0);
}

TEST(NumpyFile, ReadsTheFieldsOfAStructuredArrayWithTheirStamps) {
  const auto recording = OpenRecording(NumpyPath("run.npy"));
  const Channel run = ChannelNamed(recording->contents(), "run");
  EXPECT_EQ(*run.first, 0.0);
  EXPECT_EQ(*run.last, 1.1);
  const ReadSamples samples = ReadAll(*recording, {"run", {"pose.y", "u", "n", "eta.2", "pose.x"}});
  EXPECT_EQ(samples.time[4], 0.4);
  EXPECT_THAT(samples.rows[5], ElementsAre(-5.0, 1.25, -5.0, 5.25, 5.0));
  EXPECT_THAT(recording->contents().remarks,
              AllOf(Contains("run: the stamps are its field 't', in seconds."),
                    Contains(HasSubstr("'run': 1 field"))));
}

TEST(NumpyFile, TakesDatesAsStampsInUtc) {
  const auto recording = OpenRecording(NumpyPath("dated.npy"));
  EXPECT_EQ(*recording->contents().utc_of_zero, 0.0);
  const ReadSamples samples = ReadAll(*recording, {"dated", {"u"}});
  // 2026-05-10T00:00:00.
  EXPECT_EQ(samples.time[0], 1778371200.0);
  EXPECT_NEAR(samples.time[11], 1778371201.1, 1e-6);
}

TEST(NumpyFile, TellsWhatItPassesOver) {
  EXPECT_THAT(
      OpenRecording(NumpyPath("packed.npz"))->contents().remarks,
      AllOf(
          Contains("'cube' has 3 dimensions: passed over."),
          Contains("'z' holds texts, objects, complex numbers or long doubles: passed over."),
          Contains("'words' holds texts, objects, complex numbers or long doubles: passed over."),
          Contains("'objects' holds texts, objects, complex numbers or long doubles: passed over."),
          Contains("no channels: 1 scalar, 1 empty array."),
          Contains(HasSubstr("columns of an array are counted from 1"))));
}

TEST(NumpyFile, ImportsAnArrayWithTheStampsOfAnother) {
  const auto recording = OpenRecording(NumpyPath("stored.npz"));
  const ImportMap map = ParseImportMap(
      "map.yaml", "dof: surge\nvelocity: {channel: eta, time: {channel: t, field: value}, u: 2}\n");
  const Log log = ImportLog(NumpyPath("stored.npz"), *recording, map, std::nullopt).log;
  EXPECT_DOUBLE_EQ(log.velocity->time[7], 0.7);
  EXPECT_EQ(log.velocity->values[0][7], 7.25);
}

TEST(NumpyFile, ACutArrayHasItsWholeSamples) {
  const std::string bytes = NumpyBytes("eta.npy");
  const auto recording = OpenRecording(ScratchFile("eta.npy", bytes.substr(0, bytes.size() - 30)));
  EXPECT_EQ(ChannelNamed(recording->contents(), "eta").count, 10U);
  EXPECT_FALSE(recording->contents().IsComplete());
  EXPECT_THAT(recording->contents().remarks,
              Contains("'eta' ends before its last sample: 10 of 12 samples are there."));
}

TEST(NumpyFile, ASizeThatOnlyTheHeaderStatesTakesNoMemory) {
  for (const char* shape : {"(9223372036854775807, 2)",
                            "(2, 9223372036854775807)",
                            "(4294967296, 4294967296)",
                            "(2305843009213693952, 2305843009213693952)",
                            "(1000000000000,)"}) {
    const auto file = ScratchFile(
        "x.npy",
        Npy(std::string("{'descr': '<f8', 'fortran_order': False, 'shape': ") + shape + ", }\n",
            std::string(64, '\0')));
    EXPECT_THAT(OpenRecording(file)->contents().remarks,
                Contains(HasSubstr("ends before its last")))
        << shape;
  }
}

TEST(NumpyFile, RefusesAHeaderThatIsNone) {
  const auto error_of = [](const std::string& header) {
    return ErrorFrom([&] { OpenRecording(ScratchFile("x.npy", Npy(header, ""))); });
  };
  EXPECT_THAT(error_of("{'descr': '<f8'"), HasSubstr("x.npy: its header is damaged"));
  EXPECT_THAT(error_of("{'descr': 'f', 'fortran_order': False, 'shape': (3,)}"),
              HasSubstr("expected a type as '<f8', found 'f'"));
  EXPECT_THAT(error_of("{'descr': [('a', [('b', [], (99999,))], (99999,))], "
                       "'fortran_order': False, 'shape': (3,)}"),
              HasSubstr("fields that hold something"));
  EXPECT_THAT(error_of(std::string(5000, '(')), HasSubstr("its header is damaged"));
  std::string longer = Npy("{}", "");
  longer[9] = 'x';
  EXPECT_THAT(ErrorFrom([&] { OpenRecording(ScratchFile("x.npy", longer)); }),
              HasSubstr("ends within its header"));
}

TEST(NumpyFile, ADamagedZipIsToldOrRefused) {
  const std::string bytes = NumpyBytes("packed.npz");
  EXPECT_THAT(
      ErrorFrom([&] { OpenRecording(ScratchFile("x.npz", bytes.substr(0, bytes.size() / 2))); }),
      HasSubstr("x.npz: has no directory at its end"));
  std::string damaged = bytes;
  damaged[100] = static_cast<char>(damaged[100] ^ 0x40);  // within eta
  const auto recording = OpenRecording(ScratchFile("y.npz", damaged));
  EXPECT_THAT(recording->contents().remarks, Contains("'eta' is damaged: passed over."));
  EXPECT_FALSE(recording->contents().IsComplete());
  ExpectNumpyEta(*recording, "wide");
}

TEST(NumpyFile, DamageOfAnyByteIsNoMoreThanAnError) {
  for (const char* name : {"run.npy", "packed.npz"}) {
    const std::string bytes = NumpyBytes(name);
    RandomStream random(7, "damage");
    for (int trial = 0; trial < 400; ++trial) {
      std::string damaged = bytes;
      for (int i = 0; i < 3; ++i) {
        damaged[static_cast<std::size_t>(random.Uniform() * damaged.size())] =
            static_cast<char>(static_cast<int>(random.Uniform() * 256.0));
      }
      try {
        const auto recording = OpenRecording(ScratchFile(name, damaged));
        for (const Channel& channel : recording->contents().channels) {
          ReadAll(*recording, {channel.name, {channel.fields.front().name}});
        }
      } catch (const InputError&) {
      }
    }
  }
}

TEST(NumpyFile, TellsHowManyNumbersAreMissing) {
  const double numbers[] = {0.5, std::nan(""), 0.25, INFINITY};
  const std::string bytes =
      Npy("{'descr': '<f8', 'fortran_order': False, 'shape': (4,), }",
          std::string(reinterpret_cast<const char*>(numbers), sizeof(numbers)));
  EXPECT_THAT(
      OpenRecording(ScratchFile("u.npy", bytes))->contents().remarks,
      ElementsAre("u: 2 numbers missing, NaN or infinite, the first is sample 2 of 'value'."));
}

// Of every format: what a stream loses is counted.
TEST(NumpyFile, OfNumbersAndNanMakesAStreamThatTellsItsLoss) {
  const double numbers[] = {0.5, std::nan(""), 0.25, 0.75};
  const auto recording = OpenRecording(
      ScratchFile("u.npy",
                  Npy("{'descr': '<f8', 'fortran_order': False, 'shape': (4,), }",
                      std::string(reinterpret_cast<const char*>(numbers), sizeof(numbers)))));
  const ImportMap map =
      ParseImportMap("map.yaml", "dof: surge\nvelocity: {rate: 10, u: {field: value, unit: m/s}}");
  const ImportedLog imported = ImportLog("u.npy", *recording, map, std::nullopt);
  EXPECT_EQ(imported.log.velocity->time.size(), 3U);
  EXPECT_THAT(imported.remarks,
              Contains("velocity of u: 1 row of 4 left out, in which no cell holds a number."));
}

// Bits of IEEE 754 binary16: 1, -2, 65504, the least above 0, infinity.
TEST(NumpyFile, ReadsHalves) {
  const std::string header = "{'descr': '<f2', 'fortran_order': False, 'shape': (5,), }";
  const std::string bits("\x00\x3c\x00\xc0\xff\x7b\x01\x00\x00\x7c", 10);
  const auto recording = OpenRecording(ScratchFile("half.npy", Npy(header, bits)));
  const ReadSamples samples = ReadAll(*recording, {"half", {"value"}});
  ASSERT_EQ(samples.rows.size(), 5U);
  EXPECT_EQ(samples.rows[0][0], 1.0);
  EXPECT_EQ(samples.rows[1][0], -2.0);
  EXPECT_EQ(samples.rows[2][0], 65504.0);
  EXPECT_EQ(samples.rows[3][0], std::ldexp(1.0, -24));
  EXPECT_EQ(samples.rows[4][0], INFINITY);
}

}  // namespace
}  // namespace fathom
