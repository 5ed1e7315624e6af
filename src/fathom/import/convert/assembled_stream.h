// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/convert/channel_part.h"
#include "fathom/import/convert/samples.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/units/unit.h"
#include "fathom/log/log.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fathom {

// A stream as a recording holds it: its columns in SI, in the recording's axes.
struct GatheredStream {
  std::vector<std::string> columns;
  std::vector<Dimension> dimensions;  // of the columns
  ChannelSamples samples;             // at the stamps of the slowest channel; of a command at all
};

// Puts the channels of a stream together, its columns in the order of the map: those of a "command"
// hold their values, others are brought to the stamps of the slowest. Throws InputError for less
// than two samples.
GatheredStream Assembled(const std::filesystem::path& file,
                         const char* name,
                         const StreamMap& stream,
                         std::vector<ChannelPart> parts,
                         std::vector<StampsOutOfOrder>* out_of_order,
                         std::vector<std::string>* remarks);

}  // namespace fathom
