// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/convert/assembled_stream.h"
#include "fathom/import/convert/samples.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/recording/recording.h"
#include "fathom/log/log.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What a map takes from a recording.
struct GatheredStreams {
  std::optional<GatheredStream> command;
  std::optional<ChannelSamples> voltage;  // one column [V]
  std::optional<GatheredStream> velocity;
  std::optional<GatheredStream> pose;
  std::vector<StampsOutOfOrder> out_of_order;
  std::string row_counter;  // a column that counts rows and was taken for the stamps; else empty
  std::vector<std::string> remarks;
};

// Reads all columns of a map in one pass. Throws InputError for what the recording has not, and for
// a stream that comes out with less than two samples.
GatheredStreams GatherStreams(const std::filesystem::path& file,
                              const Recording& recording,
                              const ImportMap& map);

}  // namespace fathom
