// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sitl_child.h"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "test_folder.h"
#include <arpa/inet.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fathom {
namespace {

using SitlPath = std::filesystem::path;

void Append(std::uint32_t value, int num_bytes, std::string* bytes) {
  for (int i = 0; i < num_bytes; ++i) bytes->push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

// The numbers behind a key, as SITL finds them: a list right behind "key": .
template <int N>
Eigen::Matrix<double, N, 1> ListBehind(const std::string& text, const std::string& key) {
  Eigen::Matrix<double, N, 1> list;
  list.setConstant(std::numeric_limits<double>::quiet_NaN());
  const std::size_t at = text.find("\"" + key + "\":[");
  EXPECT_NE(at, std::string::npos) << key << " in " << text;
  if (at == std::string::npos) return list;
  std::istringstream rest(text.substr(at + key.size() + 4));
  for (int i = 0; i < N; ++i) {
    char behind = '\0';
    rest >> list[i] >> behind;
    EXPECT_EQ(behind, i + 1 < N ? ',' : ']') << key << " in " << text;
  }
  return list;
}

SitlAnswer Parsed(const std::string& text) {
  SitlAnswer answer;
  answer.text = text;
  EXPECT_EQ(text.front(), '\n');
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(text.find("\n{\"timestamp\":"), 0u) << text;
  answer.timestamp = std::strtod(text.c_str() + std::strlen("\n{\"timestamp\":"), nullptr);
  answer.gyro = ListBehind<3>(text, "gyro");
  answer.accel_body = ListBehind<3>(text, "accel_body");
  answer.position = ListBehind<3>(text, "position");
  answer.attitude = ListBehind<3>(text, "attitude");
  answer.velocity = ListBehind<3>(text, "velocity");
  answer.quaternion = ListBehind<4>(text, "quaternion");
  return answer;
}

// The port in "... 127.0.0.1:40123, ...", once the program has written it; 0 after 3 s.
std::uint16_t PortIn(const SitlPath& file) {
  for (int i = 0; i < 300; ++i) {
    std::ifstream in(file);
    std::string line;
    if (std::getline(in, line) && !in.eof()) {
      return static_cast<std::uint16_t>(std::atoi(line.c_str() + line.find("127.0.0.1:") + 10));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return 0;
}

}  // namespace

std::string BytesOf(const SitlFrame& frame, std::optional<std::uint16_t> magic) {
  std::string bytes;
  Append(magic.value_or(frame.pulses.size() == 32 ? 29569 : 18458), 2, &bytes);
  Append(frame.rate, 2, &bytes);
  Append(frame.count, 4, &bytes);
  for (const std::uint16_t pulse : frame.pulses) Append(pulse, 2, &bytes);
  return bytes;
}

SitlChild::SitlChild(const std::string& name,
                     const std::string& header,
                     const std::string& options) {
  const SitlPath folder = EmptyTestFolder();
  std::ofstream(folder / (name + ".h")) << header;
  const std::string program = (folder / "program").string(), said = (folder / "said").string();
  const ChildResult compiled = RunChild({"cc",
                                         {"-std=c11",
                                          "-Wall",
                                          "-Wextra",
                                          "-Werror",
                                          "-pedantic",
                                          "-DMODEL=" + name,
                                          fmt::format("-DMODEL_HEADER=\"{}.h\"", name),
                                          "-DSILENCE=1",
                                          "-I" + folder.string(),
                                          "-o",
                                          program,
                                          FATHOM_DATA_DIR "/examples/ardupilot_sitl.c",
                                          "-lm"}});
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  if (compiled.exit_code != 0) return;
  ChildCommand command{"sh",
                       {"-c", fmt::format("exec '{}' --port=0 {} > '{}'", program, options, said)}};
  command.limits.wall_time = 8.0;
  command.on_start = [this](int pid) { pid_ = pid; };
  runs_ = std::thread([this, command] { result_ = RunChild(command); });
  port_ = PortIn(said);
  EXPECT_NE(port_, 0);
  socket_ = socket(AF_INET, SOCK_DGRAM, 0);
}

SitlChild::~SitlChild() {
  End();
  if (socket_ >= 0) close(socket_);
}

void SitlChild::Send(const std::string& bytes) const {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port_);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(sendto(socket_,
                   bytes.data(),
                   bytes.size(),
                   0,
                   reinterpret_cast<const sockaddr*>(&to),
                   sizeof to),
            static_cast<ssize_t>(bytes.size()));
}

std::optional<SitlAnswer> SitlChild::Receive(double seconds) const {
  pollfd ready = {socket_, POLLIN, 0};
  if (poll(&ready, 1, static_cast<int>(1000.0 * seconds)) != 1) return std::nullopt;
  char buffer[4096];
  const ssize_t size = recv(socket_, buffer, sizeof buffer, 0);
  if (size <= 0) return std::nullopt;
  return Parsed({buffer, static_cast<std::size_t>(size)});
}

SitlAnswer SitlChild::AnswerTo(const SitlFrame& frame) const {
  Send(BytesOf(frame));
  const std::optional<SitlAnswer> answer = Receive(2.0);
  EXPECT_TRUE(answer.has_value()) << "to frame " << frame.count;
  return answer.value_or(SitlAnswer{});
}

std::string SitlChild::End() {
  if (!runs_.joinable()) return result_.err;
  if (pid_ > 0) kill(pid_, SIGTERM);
  runs_.join();
  return result_.err;
}

}  // namespace fathom
