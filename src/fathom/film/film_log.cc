// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/film_log.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/camera/detections_file.h"
#include "fathom/film/tag_renderer.h"
#include "fathom/images/png_file.h"

#include <cstddef>
#include <iterator>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

void WriteRig(const std::filesystem::path& folder, const Film& film) {
  WriteFile(folder / "camera.yaml", ReadFile(film.camera_file));
  WriteFile(folder / "tags.yaml", ReadFile(film.tags_file));
  WriteFile(folder / "mount.yaml", ReadFile(film.mount_file));
}

void RequireMarkersInView(std::span<const StampedPose> world_from_body, const Film& film) {
  for (const StampedPose& stamped : world_from_body) {
    const Pose world_from_camera = stamped.pose * film.rig.body_from_camera;
    if (!ObserveCorners(film.rig.camera, film.true_map, world_from_camera).empty()) return;
  }
  throw InputError(fmt::format(
      "{}: no frame shows a marker, expected the vehicle to see one. It starts at the world's "
      "origin and looks along the world's x if the camera of {} looks ahead.",
      film.tags_file.string(),
      film.mount_file.string()));
}

}  // namespace

void WriteFilmCorners(const std::filesystem::path& folder,
                      std::span<const StampedPose> world_from_body,
                      const Film& film,
                      std::uint64_t seed) {
  RequireMarkersInView(world_from_body, film);
  WriteRig(folder, film);
  WriteDetections(folder / "detections.csv", FilmCorners(world_from_body, film, seed));
}

void WriteFilmImages(const std::filesystem::path& folder,
                     std::span<const StampedPose> world_from_body,
                     const Film& film,
                     std::uint64_t seed,
                     const FilmProgress& progress) {
  RequireMarkersInView(world_from_body, film);
  const TagRenderer renderer(film.rig.camera, film.true_map, film.view);
  WriteRig(folder, film);
  const int num_images = static_cast<int>(world_from_body.size());
  std::string list = "t,file\n";
  for (std::size_t i = 0; i < world_from_body.size(); ++i) {
    const std::string file = fmt::format("frames/{:06}.png", i);
    // A seed of its own for each frame, so that frames can be drawn in any order.
    const std::uint64_t frame_seed = seed * 0x9e3779b97f4a7c15 + i;
    const std::string png =
        EncodePng(renderer.Render(PosesDuringExposure(world_from_body, i, film), frame_seed));
    if (i == 0 && progress.on_start) {
      progress.on_start(num_images,
                        static_cast<double>(num_images) * static_cast<double>(png.size()));
    }
    WriteFile(folder / file, png);
    fmt::format_to(std::back_inserter(list), "{},{}\n", world_from_body[i].time, file);
    if (progress.on_image) progress.on_image(static_cast<int>(i) + 1, num_images);
  }
  WriteFile(folder / "frames.csv", list);
}

}  // namespace fathom
