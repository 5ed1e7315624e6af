// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/our_axes.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kQuaternionTolerance = 1e-3;
constexpr double kLongestGap = 1.0;  // [s] between poses that turn a velocity

bool IsWorld(Frame frame) { return frame != Frame::kFrd && frame != Frame::kFlu; }

// Whether the body that goes with a frame has its z axis up.
bool HasBodyUp(Frame frame) { return frame != Frame::kFrd && frame != Frame::kNed; }

// Of a turn by half a circle about the x axis.
Eigen::Matrix3d HalfTurn() { return Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal(); }

Eigen::Matrix3d NedFromWorld(Frame frame) {
  if (frame == Frame::kNwu) return HalfTurn();
  if (frame != Frame::kEnu) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d ned_from_enu;
  ned_from_enu << 0.0, 1.0, 0.0,  //
      1.0, 0.0, 0.0,              //
      0.0, 0.0, -1.0;
  return ned_from_enu;
}

Eigen::Matrix3d FrdFromBody(Frame frame) {
  return HasBodyUp(frame) ? HalfTurn() : Eigen::Matrix3d::Identity().eval();
}

const std::vector<double>* Find(const GatheredStream& stream, std::string_view column) {
  for (std::size_t i = 0; i < stream.columns.size(); ++i) {
    if (stream.columns[i] == column) return &stream.samples.values[i];
  }
  return nullptr;
}

double At(const std::vector<double>* column, std::size_t row) {
  return column == nullptr ? 0.0 : (*column)[row];
}

Eigen::Quaterniond FromYawPitchRoll(double yaw, double pitch, double roll) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

void TellMissing(const GatheredStream& gathered, std::vector<std::string>* remarks) {
  const bool has_quaternion = Find(gathered, "qw") != nullptr;
  const bool has_angle = Find(gathered, "roll") != nullptr || Find(gathered, "pitch") != nullptr ||
                         Find(gathered, "yaw") != nullptr;
  const bool has_position = Find(gathered, "x") != nullptr;
  for (const char* column : {"z", "roll", "pitch", "yaw"}) {
    const bool is_asked =
        std::string_view(column) == "z" ? has_position : has_angle && !has_quaternion;
    if (is_asked && Find(gathered, column) == nullptr) {
      remarks->push_back(fmt::format("pose: the map names no {}, so it is 0.", column));
    }
  }
}

// world_from_body at a time, on the short way between two poses; nothing outside of them or in a
// gap.
std::optional<Eigen::Quaterniond> AttitudeAt(const Stream& pose, double time) {
  const auto attitude = [&](std::size_t row) {
    const auto part = [&](const char* column) { return (*pose.Find(column))[row]; };
    return Eigen::Quaterniond(part("qw"), part("qx"), part("qy"), part("qz"));
  };
  const auto after = std::lower_bound(pose.time.begin(), pose.time.end(), time);
  if (after == pose.time.end()) return std::nullopt;
  const auto row = static_cast<std::size_t>(after - pose.time.begin());
  if (*after == time) return attitude(row);
  if (row == 0) return std::nullopt;
  const double step = pose.time[row] - pose.time[row - 1];
  if (step > kLongestGap) return std::nullopt;
  return attitude(row - 1).slerp((time - pose.time[row - 1]) / step, attitude(row));
}

void Flip(std::string_view column, Stream* stream) {
  for (std::size_t i = 0; i < stream->columns.size(); ++i) {
    if (stream->columns[i] != column) continue;
    for (double& value : stream->values[i]) value = -value;
  }
}

// The rows of u, v, w that an attitude turns into the body frame; the others go.
void TurnIntoBody(const Stream& pose, Frame frame, Stream* velocity, std::size_t* num_lost) {
  Stream turned;
  turned.columns = velocity->columns;
  turned.values.resize(turned.columns.size());
  std::array<std::size_t, 3> axes = {};
  for (std::size_t i = 0; i < turned.columns.size(); ++i) {
    const std::size_t axis = std::string_view("uvw").find(turned.columns[i]);
    if (axis != std::string_view::npos) axes[axis] = i;
  }
  const Eigen::Matrix3d ned_from_world = NedFromWorld(frame);
  for (std::size_t row = 0; row < velocity->time.size(); ++row) {
    const auto world_from_body = AttitudeAt(pose, velocity->time[row]);
    if (!world_from_body) {
      ++*num_lost;
      continue;
    }
    const Eigen::Vector3d in_world(velocity->values[axes[0]][row],
                                   velocity->values[axes[1]][row],
                                   velocity->values[axes[2]][row]);
    const Eigen::Vector3d in_body = world_from_body->conjugate() * (ned_from_world * in_world);
    turned.time.push_back(velocity->time[row]);
    for (std::size_t i = 0; i < turned.columns.size(); ++i) {
      turned.values[i].push_back(velocity->values[i][row]);
    }
    for (int axis = 0; axis < 3; ++axis) turned.values[axes[axis]].back() = in_body[axis];
  }
  *velocity = std::move(turned);
}

}  // namespace

void TurnCommand(Frame frame, Stream* command) {
  if (!HasBodyUp(frame)) return;
  for (const char* column : {"tau_sway", "tau_heave", "tau_pitch", "tau_yaw"}) {
    Flip(column, command);
  }
}

Stream PosesOf(const std::filesystem::path& file,
               const GatheredStream& gathered,
               Frame frame,
               std::vector<std::string>* remarks) {
  TellMissing(gathered, remarks);
  const auto* x = Find(gathered, "x");
  const auto* y = Find(gathered, "y");
  const auto* z = Find(gathered, "z");
  const auto* qw = Find(gathered, "qw");
  const bool has_attitude = qw != nullptr || Find(gathered, "roll") != nullptr ||
                            Find(gathered, "pitch") != nullptr || Find(gathered, "yaw") != nullptr;
  const Eigen::Matrix3d ned_from_world = NedFromWorld(frame);
  const Eigen::Matrix3d body_from_frd = FrdFromBody(frame).transpose();
  Stream poses;
  if (x != nullptr) poses.columns = {"x", "y"};
  if (x != nullptr || z != nullptr) poses.columns.emplace_back("z");
  if (has_attitude) poses.columns.insert(poses.columns.end(), {"qx", "qy", "qz", "qw"});
  poses.values.resize(poses.columns.size());
  std::size_t num_lost = 0;
  for (std::size_t row = 0; row < gathered.samples.time.size(); ++row) {
    const Eigen::Quaterniond attitude = qw == nullptr
                                            ? FromYawPitchRoll(At(Find(gathered, "yaw"), row),
                                                               At(Find(gathered, "pitch"), row),
                                                               At(Find(gathered, "roll"), row))
                                            : Eigen::Quaterniond((*qw)[row],
                                                                 (*Find(gathered, "qx"))[row],
                                                                 (*Find(gathered, "qy"))[row],
                                                                 (*Find(gathered, "qz"))[row]);
    if (!(std::abs(attitude.norm() - 1.0) <= kQuaternionTolerance)) {
      ++num_lost;
      continue;
    }
    const Eigen::Vector3d position =
        ned_from_world * Eigen::Vector3d(At(x, row), At(y, row), At(z, row));
    Eigen::Quaterniond ned_from_frd(ned_from_world * attitude.normalized().toRotationMatrix() *
                                    body_from_frd);
    ned_from_frd.normalize();
    poses.time.push_back(gathered.samples.time[row]);
    std::size_t column = 0;
    for (const int axis : {0, 1, 2}) {
      if (x != nullptr || (axis == 2 && z != nullptr)) {
        poses.values[column++].push_back(position[axis]);
      }
    }
    if (!has_attitude) continue;
    for (const double part : ned_from_frd.coeffs()) poses.values[column++].push_back(part);
  }
  if (num_lost > 0) {
    remarks->push_back(fmt::format("pose: {} left out, whose quaternion is not of length 1.",
                                   Plural(num_lost, "row")));
  }
  if (poses.time.size() < 2) {
    throw InputError(fmt::format(
        "{}: pose: {} with a quaternion of length 1, expected two at least. Are qx, qy, qz, qw in "
        "the right order?",
        file.string(),
        Plural(poses.time.size(), "row")));
  }
  return poses;
}

Stream BodyVelocitiesOf(const std::filesystem::path& file,
                        const GatheredStream& gathered,
                        Frame frame,
                        const std::optional<Stream>& pose,
                        std::vector<std::string>* remarks) {
  Stream velocity = {gathered.samples.time, gathered.columns, gathered.samples.values};
  if (IsWorld(frame) && velocity.Find("u") == nullptr && velocity.Find("v") == nullptr &&
      velocity.Find("w") == nullptr) {
    frame = HasBodyUp(frame) ? Frame::kFlu : Frame::kFrd;  // rates alone
  }
  if (IsWorld(frame)) {
    if (velocity.Find("u") == nullptr || velocity.Find("v") == nullptr ||
        velocity.Find("w") == nullptr) {
      throw InputError(
          file.string() +
          ": velocity: is along the axes of the world, expected all of u, v, w to turn "
          "it into the body.");
    }
    if (!pose || pose->Find("qw") == nullptr) {
      throw InputError(file.string() +
                       ": velocity: is along the axes of the world, expected the map to give the "
                       "pose too, whose attitude turns it into the body.");
    }
    std::size_t num_lost = 0;
    TurnIntoBody(*pose, frame, &velocity, &num_lost);
    if (num_lost > 0) {
      remarks->push_back(fmt::format("velocity: {} left out, at which there is no attitude.",
                                     Plural(num_lost, "row")));
    }
    if (velocity.time.size() < 2) {
      throw InputError(file.string() + ": velocity and pose have no time in common.");
    }
  } else if (HasBodyUp(frame)) {
    for (const char* column : {"v", "w"}) Flip(column, &velocity);
  }
  if (HasBodyUp(frame)) {
    for (const char* column : {"q", "r"}) Flip(column, &velocity);
  }
  return velocity;
}

}  // namespace fathom
