// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/film/film.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace fathom {

// Whom to tell how far the images are.
struct FilmProgress {
  // Before the first one is written: how many there will be, and about how many bytes in all, by
  // the size of the first: what makes an image large is its noise, alike in all.
  std::function<void(int num_images, double num_bytes)> on_start = {};
  std::function<void(int done, int expected)> on_image = {};
};

// Write the camera's part of a log folder: camera.yaml, tags.yaml, mount.yaml and
//
//   WriteFilmCorners   detections.csv
//   WriteFilmImages    frames.csv and the rendered images, frames/000000.png, ...
//
// of a body at these poses, the stamps of the frames. Throw InputError if something cannot be
// written or, for the images, drawn, and if no frame shows a marker.
void WriteFilmCorners(const std::filesystem::path& folder,
                      std::span<const StampedPose> world_from_body,
                      const Film& film,
                      std::uint64_t seed);

void WriteFilmImages(const std::filesystem::path& folder,
                     std::span<const StampedPose> world_from_body,
                     const Film& film,
                     std::uint64_t seed,
                     const FilmProgress& progress = {});

}  // namespace fathom
