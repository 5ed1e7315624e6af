// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "dataflash_writer.h"

#include <cmath>

namespace fathom::dataflash {

std::string Text(std::string_view text, std::size_t size) {
  std::string bytes(text);
  bytes.resize(size, '\0');
  return bytes;
}

std::string Message(int type, const std::string& payload) {
  return std::string("\xa3\x95") + static_cast<char>(type) + payload;
}

std::string Fmt(int type, int length, const char* name, const char* letters, const char* columns) {
  return Message(128,
                 Bytes<std::uint8_t>(type) + Bytes<std::uint8_t>(length) + Text(name, 4) +
                     Text(letters, 16) + Text(columns, 64));
}

std::string FmtOfUnits() {
  return Fmt(131, 44, "FMTU", "QBNN", "TimeUS,FmtType,UnitIds,MultIds") +
         Fmt(132, 76, "UNIT", "QbZ", "TimeUS,Id,Label") +
         Fmt(133, 20, "MULT", "Qbd", "TimeUS,Id,Mult");
}

std::string Unit(char id, const char* label) {
  return Message(132, Bytes<std::uint64_t>(0) + id + Text(label, 64));
}

std::string Mult(char id, double multiplier) {
  return Message(133, Bytes<std::uint64_t>(0) + id + Bytes(multiplier));
}

std::string Fmtu(int type, const char* unit_ids, const char* multiplier_ids) {
  return Message(131,
                 Bytes<std::uint64_t>(0) + Bytes<std::uint8_t>(type) + Text(unit_ids, 16) +
                     Text(multiplier_ids, 16));
}

std::string FmtOfAtt() { return Fmt(kAtt, 19, "ATT", "QcHf", "TimeUS,Roll,Count,Rate"); }

std::string Att(std::uint64_t time_us, double roll, int count, float rate) {
  return Message(kAtt,
                 Bytes(time_us) + Bytes(static_cast<std::int16_t>(std::lround(roll * 100.0))) +
                     Bytes(static_cast<std::uint16_t>(count)) + Bytes(rate));
}

}  // namespace fathom::dataflash
