// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/convert/gather_streams.h"
#include "fathom/log/log.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// Streams in Fathom's axes: body x forward, y starboard, z down; world north, east, down
// (docs/notation.md). A body or world with z up has y and z of each vector turned, or for ENU x
// and y exchanged and z turned.

// Forces of a body frame: FRD or FLU.
void TurnCommand(Frame frame, Stream* command);

// Poses x y z qx qy qz qw of a stream that gives the attitude as a quaternion or as yaw, pitch,
// roll about z, y', x''. A height, roll or pitch that it lacks is 0, which `remarks` then tells.
// Quaternions are brought to length 1; rows where it is off by over 1e-3 are left out and counted.
// Throws InputError, naming `file`, if fewer than two rows are left.
Stream PosesOf(const std::filesystem::path& file,
               const GatheredStream& gathered,
               Frame frame,
               std::vector<std::string>* remarks);

// Velocities in the body frame. Those along a world's axes (NED, ENU, NWU) are turned by the
// attitude of `pose`, and rows where there is none are left out and counted; rates are along the
// body's axes in any frame. Throws InputError, naming `file`, if `pose` is needed and missing, or
// the stream has not all of u, v, w.
Stream BodyVelocitiesOf(const std::filesystem::path& file,
                        const GatheredStream& gathered,
                        Frame frame,
                        const std::optional<Stream>& pose,
                        std::vector<std::string>* remarks);

}  // namespace fathom
