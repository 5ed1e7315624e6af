// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/time_interval.h"
#include "fathom/log/correction.h"
#include "fathom/log/remark.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// One file of a log: columns of equal length over stamps of its own clock.
struct Stream {
  std::vector<double> time;                 // [s], strictly increasing (detections: not falling)
  std::vector<std::string> columns;         // names, without "t"
  std::vector<std::vector<double>> values;  // values[column][row], SI, finite

  // Null if there is no such column.
  const std::vector<double>* Find(std::string_view column) const;
};

// Stamps of a stream that lay before that of an earlier row, and were put in order.
struct StampsOutOfOrder {
  std::string stream;  // "velocity"
  double share = 0.0;  // of its rows
};

// The recording that fathom_import made a log from.
struct LogOrigin {
  std::string file;     // its name, without folders
  std::string content;  // ContentOf() it
  std::string map;      // a file in the log's folder: what says which channel is which stream

  std::vector<StampsOutOfOrder> out_of_order;  // of the recording
  std::string row_counter;  // its column that counts rows and was taken for stamps; may be empty
};

// What a log folder (or a single CSV) holds; docs/file_formats.md.
struct Log {
  std::filesystem::path path;
  std::string name;
  std::vector<Dof> dofs;  // the excited ones
  std::string vehicle;    // a file name or free text, as in log.yaml
  std::string notes;
  std::string dive;                     // which logs belong together; may be empty
  std::optional<double> start;          // when it began, as log.yaml says [s since 1970, UTC]
  std::vector<TimeInterval> held_out;   // not to be trained on; may be empty
  std::optional<double> mass;           // of the vehicle, dry [kg]; see OpenLog()
  std::string command_unit;             // empty: N and N m
  std::string thruster_unit;            // of a command of thrusters, "N"; empty: Hz
  std::string video;                    // of a camera log, a file in its folder; may be empty
  double video_start = 0.0;             // when the video's own clock is at 0 [s], in the log's time
  std::vector<Correction> corrections;  // that velocity is multiplied by already
  std::optional<LogOrigin> origin;      // of a log that was imported

  std::optional<Stream> command;    // tau_* [N, N m], or thruster_* [thruster_unit] until OpenLog()
  std::optional<Stream> thrusters;  // thruster_* [N], which the command was made of; OpenLog()
  std::optional<Stream> fins;       // fin_<name> [rad], at the command's stamps
  std::optional<Stream> shafts;     // shaft_<name> [Hz], likewise
  std::optional<Stream> velocity;   // u v w p q r [m/s, rad/s], body frame
  std::optional<Stream> pose;       // x y z [m] qx qy qz qw: world_from_body. Attitude alone, z
                                    // alone, or both, where no more is known

  // tag_id u0 v0 ... u3 v3 [px]: corners of markers, a row for each tag of each frame. What they
  // mean takes the calibration: fathom/camera/detections_file.h, camera_rig.h.
  std::optional<Stream> detections;

  // What the reader passed over, counted, a sentence each ("velocity.csv: 12 further columns are
  // not read: ..."). Tools print them.
  std::vector<Remark> remarks;
};

}  // namespace fathom
