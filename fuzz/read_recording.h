// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/input_error.h"
#include "fathom/import/recording/contents_json.h"
#include "fathom/import/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "memory_file.h"

// The bytes as a recording; what is listed must then be readable. `open`: makes a recording of a
// path.
template <typename Open>
int ReadRecording(const std::uint8_t* data, std::size_t size, const Open& open) {
  const MemoryFile file(data, size);
  try {
    const auto recording = open(file.path());
    fathom::FormatContents(recording->contents());
    std::vector<fathom::Selection> selections;
    for (const fathom::Channel& channel : recording->contents().channels) {
      fathom::Selection selection = {channel.name, {}};
      for (const fathom::Field& field : channel.fields) selection.fields.push_back(field.name);
      selections.push_back(selection);
    }
    recording->Read(selections, [](std::size_t, double, std::span<const double>) {});
  } catch (const fathom::InputError&) {
  }
  return 0;
}
