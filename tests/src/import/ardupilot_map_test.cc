// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"

#include <cstdint>
#include <optional>
#include <string>

#include "dataflash_writer.h"
#include "scratch_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using dataflash::Bytes;
using dataflash::Fmt;
using dataflash::Message;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int kParm = 64, kRcou = 65;

std::string Parameter(const char* name, float value) {
  return Message(kParm, Bytes<std::uint64_t>(0) + dataflash::Text(name, 16) + Bytes(value));
}

std::string Outputs(std::uint64_t time_us, std::uint16_t c1, std::uint16_t c2, std::uint16_t c3) {
  return Message(kRcou, Bytes(time_us) + Bytes(c1) + Bytes(c2) + Bytes(c3));
}

// A setting that is stated again has changed.
TEST(ArdupilotMap, TurnsAroundThePulsesOfReversedMotors) {
  const std::string log = Fmt(kParm, 31, "PARM", "QNf", "TimeUS,Name,Value") +
                          Fmt(kRcou, 17, "RCOU", "QHHH", "TimeUS,C1,C2,C3") +
                          Parameter("MOT_1_DIRECTION", -1.0F) +
                          Parameter("MOT_2_DIRECTION", -1.0F) + Parameter("MOT_3_DIRECTION", 1.0F) +
                          Parameter("MOT_1_DIRECTION", 1.0F) + Outputs(1000, 1500, 1600, 1400) +
                          Outputs(2000, 1510, 1590, 1410);
  const auto recording = OpenRecording(ScratchFile("dive.BIN", log));
  EXPECT_EQ(recording->contents().parameters.at("MOT_2_DIRECTION"), -1.0);
  EXPECT_THAT(SuggestMap(*recording, std::nullopt).text,
              AllOf(HasSubstr("  thruster_1: C1\n"),
                    HasSubstr("  thruster_2: {field: C2, scale: -1, offset: 3000}"),
                    HasSubstr("  thruster_3: C3\n")));
}

}  // namespace
}  // namespace fathom
