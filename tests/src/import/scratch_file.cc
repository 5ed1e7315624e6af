// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scratch_file.h"

#include "fathom/base/files/output_file.h"

#include <span>

#include "test_folder.h"
#include <gtest/gtest.h>

namespace fathom {

std::filesystem::path ScratchFile(const std::string& name, const std::string& bytes) {
  const std::filesystem::path path = TestFolder() / name;
  WriteFile(path, bytes);
  return path;
}

ReadSamples ReadAll(const Recording& recording, const Selection& selection) {
  ReadSamples samples;
  const auto take = [&](std::size_t, double time, std::span<const double> values) {
    samples.time.push_back(time);
    samples.rows.emplace_back(values.begin(), values.end());
  };
  samples.remarks = recording.Read({&selection, 1}, take);
  return samples;
}

Channel ChannelNamed(const Contents& contents, const std::string& name) {
  for (const Channel& channel : contents.channels) {
    if (channel.name == name) return channel;
  }
  ADD_FAILURE() << "no channel " << name;
  return {};
}

}  // namespace fathom
