// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

#include "dataflash_writer.h"
#include "scratch_file.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using dataflash::Bytes;
using dataflash::Fmt;
using dataflash::Message;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kParm = 64, kRcou = 65;

std::string Parameter(const char* name, float value) {
  return Message(kParm, Bytes<std::uint64_t>(0) + dataflash::Text(name, 16) + Bytes(value));
}

std::string Outputs(std::uint64_t time_us, std::uint16_t c1, std::uint16_t c2, std::uint16_t c3) {
  return Message(kRcou, Bytes(time_us) + Bytes(c1) + Bytes(c2) + Bytes(c3));
}

const std::string kFormats = Fmt(kParm, 31, "PARM", "QNf", "TimeUS,Name,Value") +
                             Fmt(kRcou, 17, "RCOU", "QHHH", "TimeUS,C1,C2,C3");

// So many motors that turn the right way round, motor 1 by the output of this number.
std::string Functions(std::initializer_list<float> functions) {
  std::string bytes;
  int output = 0;
  for (const float function : functions) {
    bytes += Parameter(fmt::format("SERVO{}_FUNCTION", ++output).c_str(), function);
  }
  for (int motor = 1; motor <= 12; ++motor) {
    bytes += Parameter(fmt::format("MOT_{}_DIRECTION", motor).c_str(), 1.0F);
  }
  return bytes;
}

SuggestedMap MapOf(const std::string& messages, const std::optional<Vehicle>& vehicle = {}) {
  return SuggestMap(*OpenRecording(ScratchFile("dive.BIN", kFormats + messages)), vehicle);
}

const std::string kPulses = Outputs(1000, 1500, 1600, 1400) + Outputs(2000, 1510, 1590, 1410);

// A setting that is stated again has changed.
TEST(ArdupilotMap, TurnsAroundThePulsesOfReversedMotors) {
  const std::string log = Functions({33, 34, 35}) + Parameter("MOT_1_DIRECTION", -1.0F) +
                          Parameter("MOT_2_DIRECTION", -1.0F) + Parameter("MOT_1_DIRECTION", 1.0F) +
                          kPulses;
  EXPECT_THAT(
      MapOf(log).text,
      AllOf(HasSubstr("  thruster_1: C1\n"),
            HasSubstr("  thruster_2: {field: C2, reversed: true}  # MOT_2_DIRECTION is -1\n"),
            HasSubstr("  thruster_3: C3\n")));
}

TEST(ArdupilotMap, TakesTheOutputThatDrivesEachMotor) {
  const SuggestedMap map = MapOf(Functions({35, 33, 34}) + kPulses);
  EXPECT_THAT(map.text,
              AllOf(HasSubstr("  thruster_1: C2  # SERVO2_FUNCTION is 33\n"),
                    HasSubstr("  thruster_2: C3  # SERVO3_FUNCTION is 34\n"),
                    HasSubstr("  thruster_3: C1  # SERVO1_FUNCTION is 35\n"),
                    Not(HasSubstr("Not ready"))));
}

// Lights (59) and an output that is off (0) between two motors.
TEST(ArdupilotMap, TakesNoOutputForAThrusterThatIsNoMotor) {
  const SuggestedMap map = MapOf(Functions({33, 59, 34}) + kPulses);
  EXPECT_THAT(map.text,
              AllOf(HasSubstr("  thruster_1: C1\n"),
                    HasSubstr("  thruster_2: C3"),
                    Not(HasSubstr("C2")),
                    Not(HasSubstr("thruster_3"))));
  EXPECT_THAT(MapOf(Functions({59, 0, 7}) + kPulses).text,
              StartsWith("# Not ready: no output is a motor's"));
}

// Motor 9 and on have functions of their own.
TEST(ArdupilotMap, KnowsTheFunctionsOfMotors9To12) {
  const SuggestedMap map = MapOf(Functions({82, 33, 40}) + kPulses);
  EXPECT_THAT(map.text,
              AllOf(StartsWith("# Not ready: no output drives motor 2 of 9."),
                    HasSubstr("  thruster_1: C2"),
                    HasSubstr("  # thruster_2: ?\n"),
                    HasSubstr("  thruster_8: C3"),
                    HasSubstr("  thruster_9: C1  # SERVO1_FUNCTION is 82\n")));
}

TEST(ArdupilotMap, SaysFirstThatItIsNotReadyWhereTheSettingsAreUnknown) {
  const SuggestedMap map = MapOf(kPulses);
  EXPECT_FALSE(map.is_ready);
  EXPECT_FALSE(map.needs_vehicle);
  EXPECT_THAT(map.text, StartsWith("# Not ready: which output drives which motor is not known"));
  EXPECT_THAT(map.text, HasSubstr("  thruster_3: C3\n"));
  const SuggestedMap undirected =
      MapOf(Parameter("SERVO1_FUNCTION", 33.0F) + Parameter("SERVO2_FUNCTION", 34.0F) + kPulses);
  EXPECT_THAT(undirected.text,
              StartsWith("# Not ready: which way round motor 1 turns is not known"));
  EXPECT_FALSE(undirected.is_ready);
}

// Outputs 15 and on stand in messages of their own.
TEST(ArdupilotMap, FindsMotorsOfOutputsBehindTheFourteenth) {
  constexpr int kRco2 = 66;
  const auto more = [](std::uint64_t time_us) {
    return Message(kRco2, Bytes(time_us) + Bytes<std::uint16_t>(1550));
  };
  const SuggestedMap map =
      MapOf(Fmt(kRco2, 13, "RCO2", "QH", "TimeUS,C15") + Functions({33}) +
            Parameter("SERVO15_FUNCTION", 34.0F) + kPulses + more(1000) + more(2000));
  EXPECT_THAT(map.text, HasSubstr("  thruster_2: {channel: \"RCO2\", field: C15}"));
}

TEST(ArdupilotMap, SaysThatALogIsASimulation) {
  const auto remarks = [](const std::string& setting) {
    const auto file =
        ScratchFile("dive.BIN", kFormats + Parameter(setting.c_str(), 1.0F) + kPulses);
    return OpenRecording(file)->contents().remarks;
  };
  EXPECT_THAT(remarks("SIM_RATE_HZ"), Contains(HasSubstr("this is a simulation")));
  EXPECT_THAT(remarks("SIMPLE_MODE"), IsEmpty());
}

}  // namespace
}  // namespace fathom
