// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/detections_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/log/log_streams.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <string>

#include <fmt/format.h>

namespace fathom {

std::vector<Detection> DetectionsOf(const Stream& stream) {
  const std::vector<double>& tag_id = *stream.Find("tag_id");
  std::array<const std::vector<double>*, 4> u, v;
  for (std::size_t i = 0; i < 4; ++i) {
    u[i] = stream.Find(fmt::format("u{}", i));
    v[i] = stream.Find(fmt::format("v{}", i));
  }
  std::vector<Detection> detections(stream.time.size());
  for (std::size_t row = 0; row < detections.size(); ++row) {
    detections[row].time = stream.time[row];
    detections[row].tag_id = static_cast<int>(tag_id[row]);
    for (std::size_t i = 0; i < 4; ++i) {
      detections[row].corners[i] = {(*u[i])[row], (*v[i])[row]};
    }
  }
  return detections;
}

std::vector<Detection> ReadDetections(const std::filesystem::path& path) {
  return DetectionsOf(ParseDetections(path.string(), ReadFile(path)).stream);
}

void WriteDetections(const std::filesystem::path& path, std::span<const Detection> detections) {
  std::string csv = "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n";
  for (const Detection& detection : detections) {
    fmt::format_to(std::back_inserter(csv), "{},{}", detection.time, detection.tag_id);
    for (const Eigen::Vector2d& corner : detection.corners) {
      fmt::format_to(std::back_inserter(csv), ",{:.4f},{:.4f}", corner.x(), corner.y());
    }
    csv += "\n";
  }
  WriteFile(path, csv);
}

}  // namespace fathom
