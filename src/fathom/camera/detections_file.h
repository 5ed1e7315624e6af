// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/detection.h"
#include "fathom/log/log.h"

#include <filesystem>
#include <span>
#include <vector>

namespace fathom {

// The detections of a log's stream (Log::detections), in its order.
std::vector<Detection> DetectionsOf(const Stream& stream);

// Reads a file of detections. Throws InputError, naming file, line and column.
std::vector<Detection> ReadDetections(const std::filesystem::path& path);

// Writes detections.csv: pixels rounded to 1e-4, stamps to read back to the bit. The detections
// must stand in the order of their stamps.
void WriteDetections(const std::filesystem::path& path, std::span<const Detection> detections);

}  // namespace fathom
