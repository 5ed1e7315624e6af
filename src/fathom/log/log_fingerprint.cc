// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_fingerprint.h"

#include <cstdint>
#include <cstring>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

class Hash {
 public:
  void Add(const std::vector<double>& numbers) {
    for (const double number : numbers) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &number, sizeof bits);
      for (int shift = 0; shift < 64; shift += 8) AddByte((bits >> shift) & 0xFF);
    }
  }
  void Add(const std::string& text) {
    for (const char c : text) AddByte(static_cast<unsigned char>(c));
    AddByte(0);
  }
  std::uint64_t value() const { return value_; }

 private:
  void AddByte(std::uint64_t byte) { value_ = (value_ ^ byte) * 0x100000001b3; }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

void Add(const Stream& stream, Hash* hash) {
  hash->Add(stream.time);
  for (std::size_t i = 0; i < stream.columns.size(); ++i) {
    hash->Add(stream.columns[i]);
    hash->Add(stream.values[i]);
  }
}

}  // namespace

std::string FingerprintOf(const Log& log) {
  Hash hash;
  for (const std::optional<Stream>* stream : {&log.command, &log.velocity, &log.pose}) {
    // Poses beside detections come from them, before a tool reads the log or as it does.
    const bool is_made = stream == &log.pose && log.detections;
    hash.Add(*stream && !is_made ? "stream" : "none");
    if (*stream && !is_made) Add(**stream, &hash);
  }
  // Logs without fins, shafts or a camera keep the fingerprints they had.
  if (log.fins) Add(*log.fins, &hash);
  if (log.shafts) Add(*log.shafts, &hash);
  if (log.detections) {
    hash.Add("detections");
    Add(*log.detections, &hash);
  }
  return fmt::format("{:016x}", hash.value());
}

std::vector<std::string> FingerprintsOf(std::span<const Log> logs) {
  std::vector<std::string> fingerprints;
  for (const Log& log : logs) fingerprints.push_back(FingerprintOf(log));
  return fingerprints;
}

}  // namespace fathom
