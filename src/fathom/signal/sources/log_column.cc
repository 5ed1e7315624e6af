// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/sources/log_column.h"

#include "fathom/base/input_error.h"
#include "fathom/signal/pose_velocity.h"

#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {

std::string FileOf(const Log& log, const char* file) {
  if (log.path.empty()) return file;
  const bool is_csv = log.path.extension() == ".csv";
  return is_csv ? log.path.string() : (log.path / file).string();
}

std::string PoseFileOf(const Log& log) {
  const std::string file = FileOf(log, "pose.csv");
  std::error_code error;
  const bool is_tracked = log.detections && !std::filesystem::exists(file, error);
  return is_tracked ? FileOf(log, "detections.csv") : file;
}

HeldCommand CommandOf(const Log& log, Dof dof) {
  const std::string file = FileOf(log, "command.csv");
  const std::string column(ForceColumn(dof));
  if (!log.command) {
    throw InputError(fmt::format(
        "{}: the log has no command, expected a stream with column '{}'. Identification needs "
        "the force that drove the vehicle.",
        file,
        column));
  }
  const std::vector<double>* values = log.command->Find(column);
  if (values == nullptr) {
    const bool has_thrusters =
        !log.command->columns.empty() && log.command->columns.front().starts_with("thruster_");
    throw InputError(fmt::format(
        "{}: column '{}' is missing; the columns are {}. {}",
        file,
        column,
        fmt::join(log.command->columns, ", "),
        has_thrusters ? "Name a vehicle file, so that thruster speeds can be turned into forces."
                      : "Choose a DOF that was commanded, or another log."));
  }
  return {log.command->time, *values};
}

std::string CommandUnitOf(const Log& log, Dof dof) {
  return log.command_unit.empty() ? std::string(ForceUnit(dof)) : log.command_unit;
}

std::string RemarkOnEarlyEnd(const HeldCommand& command,
                             const std::vector<double>& time,
                             double longest_gap) {
  const double after = time.back() - command.time.back();
  if (!(after > longest_gap)) return "";
  return fmt::format("The command ends {:.1f} s before the motion; its last value is held.", after);
}

const Stream& MotionStream(const Log& log, Dof dof, Source source) {
  const bool camera = source == Source::kCamera;
  const std::optional<Stream>& stream = camera ? log.pose : log.velocity;
  const std::string file = FileOf(log, camera ? "pose.csv" : "velocity.csv");
  if (!stream) {
    throw InputError(fmt::format(
        "{}: there is no such stream in this log, expected it for the source {}. {}",
        file,
        Name(source),
        (camera ? log.velocity : log.pose)
            ? fmt::format("This log has the source {}.",
                          Name(camera ? Source::kPoseEstimator : Source::kCamera))
            : "Record the vehicle's motion, or make poses from images with fathom_track."));
  }
  if (!camera && stream->Find(VelocityColumn(dof)) == nullptr) {
    throw InputError(
        fmt::format("{}: column '{}' is missing; the columns are {}. Choose a DOF that was "
                    "measured.",
                    file,
                    VelocityColumn(dof),
                    fmt::join(stream->columns, ", ")));
  }
  if (camera && !TellsMotion(*stream, dof)) {
    throw InputError(fmt::format("{}: holds {}, which tells nothing of {}; expected {}.",
                                 file,
                                 fmt::join(stream->columns, ", "),
                                 Name(dof),
                                 IsAngular(dof)       ? "an attitude (qx, qy, qz, qw)"
                                 : dof == Dof::kHeave ? "z"
                                                      : "a position (x, y, z)"));
  }
  return *stream;
}

}  // namespace fathom
