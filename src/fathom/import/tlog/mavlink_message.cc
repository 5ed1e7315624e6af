// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/tlog/mavlink_message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// "type name unit;type[count] name unit;..." in the order of the payload, which is that of the
// definition by falling size of the numbers. Of the extensions of MAVLink 2 those of RAW_IMU and
// SERVO_OUTPUT_RAW follow; others are not read.
struct MavlinkDefinition {
  std::uint32_t id;
  const char* name;
  std::uint8_t crc_extra;
  const char* fields;
};

// From the headers that mavgen makes of MAVLink's common.xml and ardupilotmega.xml. CRC_EXTRA is a
// checksum of names, types and order of the fields without extensions: that of a wrong line would
// differ.
constexpr MavlinkDefinition kMavlinkDefinitions[] = {
    {0,
     "HEARTBEAT",
     50,
     "uint32_t custom_mode;uint8_t type;uint8_t autopilot;uint8_t base_mode;"
     "uint8_t system_status;uint8_t mavlink_version"},
    {1,
     "SYS_STATUS",
     124,
     "uint32_t onboard_control_sensors_present;uint32_t onboard_control_sensors_enabled;"
     "uint32_t onboard_control_sensors_health;uint16_t load d%;"
     "uint16_t voltage_battery mV;int16_t current_battery cA;uint16_t drop_rate_comm c%;"
     "uint16_t errors_comm;uint16_t errors_count1;uint16_t errors_count2;"
     "uint16_t errors_count3;uint16_t errors_count4;int8_t battery_remaining %"},
    {22,
     "PARAM_VALUE",
     220,
     "float param_value;uint16_t param_count;uint16_t param_index;char[16] param_id;"
     "uint8_t param_type"},
    {27,
     "RAW_IMU",
     144,
     "uint64_t time_usec us;int16_t xacc;int16_t yacc;int16_t zacc;int16_t xgyro;"
     "int16_t ygyro;int16_t zgyro;int16_t xmag;int16_t ymag;int16_t zmag;uint8_t id;"
     "int16_t temperature cdegC"},
    {29,
     "SCALED_PRESSURE",
     115,
     "uint32_t time_boot_ms ms;float press_abs hPa;float press_diff hPa;"
     "int16_t temperature cdegC"},
    {30,
     "ATTITUDE",
     39,
     "uint32_t time_boot_ms ms;float roll rad;float pitch rad;float yaw rad;"
     "float rollspeed rad/s;float pitchspeed rad/s;float yawspeed rad/s"},
    {31,
     "ATTITUDE_QUATERNION",
     246,
     "uint32_t time_boot_ms ms;float q1;float q2;float q3;float q4;float rollspeed rad/s;"
     "float pitchspeed rad/s;float yawspeed rad/s"},
    {32,
     "LOCAL_POSITION_NED",
     185,
     "uint32_t time_boot_ms ms;float x m;float y m;float z m;float vx m/s;float vy m/s;"
     "float vz m/s"},
    {33,
     "GLOBAL_POSITION_INT",
     104,
     "uint32_t time_boot_ms ms;int32_t lat degE7;int32_t lon degE7;int32_t alt mm;"
     "int32_t relative_alt mm;int16_t vx cm/s;int16_t vy cm/s;int16_t vz cm/s;"
     "uint16_t hdg cdeg"},
    {36,
     "SERVO_OUTPUT_RAW",
     222,
     "uint32_t time_usec us;uint16_t servo1_raw us;uint16_t servo2_raw us;"
     "uint16_t servo3_raw us;uint16_t servo4_raw us;uint16_t servo5_raw us;"
     "uint16_t servo6_raw us;uint16_t servo7_raw us;uint16_t servo8_raw us;uint8_t port;"
     "uint16_t servo9_raw us;uint16_t servo10_raw us;uint16_t servo11_raw us;"
     "uint16_t servo12_raw us;uint16_t servo13_raw us;uint16_t servo14_raw us;"
     "uint16_t servo15_raw us;uint16_t servo16_raw us"},
    {65,
     "RC_CHANNELS",
     118,
     "uint32_t time_boot_ms ms;uint16_t chan1_raw us;uint16_t chan2_raw us;"
     "uint16_t chan3_raw us;uint16_t chan4_raw us;uint16_t chan5_raw us;"
     "uint16_t chan6_raw us;uint16_t chan7_raw us;uint16_t chan8_raw us;"
     "uint16_t chan9_raw us;uint16_t chan10_raw us;uint16_t chan11_raw us;"
     "uint16_t chan12_raw us;uint16_t chan13_raw us;uint16_t chan14_raw us;"
     "uint16_t chan15_raw us;uint16_t chan16_raw us;uint16_t chan17_raw us;"
     "uint16_t chan18_raw us;uint8_t chancount;uint8_t rssi"},
    {69,
     "MANUAL_CONTROL",
     243,
     "int16_t x;int16_t y;int16_t z;int16_t r;uint16_t buttons;uint8_t target"},
    {74,
     "VFR_HUD",
     20,
     "float airspeed m/s;float groundspeed m/s;float alt m;float climb m/s;"
     "int16_t heading deg;uint16_t throttle %"},
    {102,
     "VISION_POSITION_ESTIMATE",
     158,
     "uint64_t usec us;float x m;float y m;float z m;float roll rad;float pitch rad;"
     "float yaw rad"},
    {116,
     "SCALED_IMU2",
     76,
     "uint32_t time_boot_ms ms;int16_t xacc mG;int16_t yacc mG;int16_t zacc mG;"
     "int16_t xgyro mrad/s;int16_t ygyro mrad/s;int16_t zgyro mrad/s;int16_t xmag mgauss;"
     "int16_t ymag mgauss;int16_t zmag mgauss"},
    {137,
     "SCALED_PRESSURE2",
     195,
     "uint32_t time_boot_ms ms;float press_abs hPa;float press_diff hPa;"
     "int16_t temperature cdegC"},
    {147,
     "BATTERY_STATUS",
     154,
     "int32_t current_consumed mAh;int32_t energy_consumed hJ;int16_t temperature cdegC;"
     "uint16_t[10] voltages mV;int16_t current_battery cA;uint8_t id;"
     "uint8_t battery_function;uint8_t type;int8_t battery_remaining %"},
    {331,
     "ODOMETRY",
     91,
     "uint64_t time_usec us;float x m;float y m;float z m;float[4] q;float vx m/s;"
     "float vy m/s;float vz m/s;float rollspeed rad/s;float pitchspeed rad/s;"
     "float yawspeed rad/s;float[21] pose_covariance;float[21] velocity_covariance;"
     "uint8_t frame_id;uint8_t child_frame_id"},
    {11011,
     "VISION_POSITION_DELTA",
     106,
     "uint64_t time_usec us;uint64_t time_delta_usec us;float[3] angle_delta rad;"
     "float[3] position_delta m;float confidence %"},
};

// The text up to a separator, which is taken off with it.
std::string_view TakeWord(std::string_view* text, char separator) {
  const std::string_view word = text->substr(0, text->find(separator));
  text->remove_prefix(std::min(word.size() + 1, text->size()));
  return word;
}

MavlinkMessage MessageOf(const MavlinkDefinition& definition) {
  MavlinkMessage message;
  message.id = definition.id;
  message.name = definition.name;
  message.crc_extra = definition.crc_extra;
  std::string_view fields = definition.fields;
  while (!fields.empty()) {
    std::string_view field = TakeWord(&fields, ';');
    std::string_view type = TakeWord(&field, ' ');
    const std::string_view name = TakeWord(&field, ' ');
    int count = 1;
    const std::size_t bracket = type.find('[');
    if (bracket != std::string_view::npos) {
      std::from_chars(type.data() + bracket + 1, type.data() + type.size() - 1, count);
    }
    type = type.substr(0, bracket);
    const NumberType packed = PackedTypeNamed(type).value_or(NumberType::kUint8);
    for (int i = 0; i < count; ++i) {
      std::string element(name);
      if (bracket != std::string_view::npos) element += fmt::format("[{}]", i);
      message.numbers.push_back({std::move(element), packed, message.size, type == "char"});
      message.units.emplace_back(field);
      message.size += SizeOf(packed);
    }
  }
  return message;
}

// What eight steps of the checksum, a bit each, make of every byte.
constexpr std::array<std::uint16_t, 256> ChecksumsOfBytes() {
  std::array<std::uint16_t, 256> checksums = {};
  for (std::size_t byte = 0; byte < checksums.size(); ++byte) {
    auto crc = static_cast<std::uint16_t>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = static_cast<std::uint16_t>((crc & 1) != 0 ? (crc >> 1) ^ 0x8408 : crc >> 1);
    }
    checksums[byte] = crc;
  }
  return checksums;
}

}  // namespace

const MavlinkMessage* FindMavlinkMessage(std::uint32_t id) {
  static const auto* const kMessages = [] {
    auto* messages = new std::map<std::uint32_t, MavlinkMessage>;
    for (const MavlinkDefinition& definition : kMavlinkDefinitions) {
      messages->emplace(definition.id, MessageOf(definition));
    }
    return messages;
  }();
  const auto found = kMessages->find(id);
  return found == kMessages->end() ? nullptr : &found->second;
}

std::uint16_t MavlinkChecksum(std::string_view bytes, std::uint8_t crc_extra) {
  static constexpr std::array<std::uint16_t, 256> kOfByte = ChecksumsOfBytes();
  std::uint16_t crc = 0xffff;
  const auto take = [&crc](unsigned char byte) {
    crc = static_cast<std::uint16_t>((crc >> 8) ^ kOfByte[(crc ^ byte) & 0xff]);
  };
  for (const char c : bytes) take(static_cast<unsigned char>(c));
  take(crc_extra);
  return crc;
}

}  // namespace fathom
