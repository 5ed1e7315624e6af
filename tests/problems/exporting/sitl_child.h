// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/process/run_child.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A frame as ArduPilot's SITL sends it.
struct SitlFrame {
  std::uint16_t rate = 50;  // [Hz]
  std::uint32_t count = 0;
  std::vector<std::uint16_t> pulses = std::vector<std::uint16_t>(16, 1500);  // [us], 16 or 32
};

// Its bytes; `magic` in place of the right one.
std::string BytesOf(const SitlFrame& frame, std::optional<std::uint16_t> magic = {});

// What SITL's reader finds in an answer.
struct SitlAnswer {
  std::string text;
  double timestamp = 0.0;
  Eigen::Vector3d gyro, accel_body, position, attitude, velocity;
  Eigen::Vector4d quaternion;  // w, x, y, z
};

// data/examples/ardupilot_sitl.c with an exported header: compiled as strictly as C compilers can,
// started at a free port of loopback, and ended with this object, or after 8 s by itself.
class SitlChild {
 public:
  // `header` is that of the model `name`. A failure to compile or to start fails the test, and
  // nothing answers.
  SitlChild(const std::string& name, const std::string& header, const std::string& options = "");
  ~SitlChild();
  SitlChild(const SitlChild&) = delete;
  SitlChild& operator=(const SitlChild&) = delete;

  void Send(const std::string& bytes) const;

  // Nothing where none comes in time.
  std::optional<SitlAnswer> Receive(double seconds) const;

  // The answer to a frame; fails the test where none comes within 2 s.
  SitlAnswer AnswerTo(const SitlFrame& frame) const;

  // Ends the child and gives what it wrote to stderr.
  std::string End();

 private:
  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::atomic<int> pid_ = 0;
  ChildResult result_;
  std::thread runs_;
};

}  // namespace fathom
