// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fathom {

// One of several files that belong together.
struct RecordingPart {
  std::string file;  // its name
  std::unique_ptr<Recording> recording;
};

// Several recordings as one, `folder` by name. Channels of one name and type in several files are
// one channel, as where a recorder began a new file; the files follow each other by their first
// stamps, then by name. Channels of one name and several types, and tables of one name, are
// "FILE/NAME". The stamps are put on one clock (joined_clocks.h), and files of which nothing tells
// how are not read together: InputError. `remarks`: to be told before those of the parts. Throws
// InputError without parts.
std::unique_ptr<Recording> JoinRecordings(const std::filesystem::path& folder,
                                          std::vector<RecordingPart> parts,
                                          std::vector<std::string> remarks);

}  // namespace fathom
