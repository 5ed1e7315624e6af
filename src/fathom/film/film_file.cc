// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/film_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/files/yaml_numbers.h"
#include "fathom/camera/camera_file.h"
#include "fathom/camera/mount_file.h"
#include "fathom/camera/tags_file.h"

#include <optional>

namespace fathom {
namespace {

WaterView ReadView(const std::optional<YamlMap>& map) {
  WaterView view;
  if (!map) return view;
  const auto grey = [&](const char* key, double* value) {
    *value = NumberWithin(*map, key, 0.0, 255.0, *value);
  };
  grey("white", &view.white);
  grey("black", &view.black);
  grey("wall", &view.wall);
  grey("veiling_light", &view.veiling_light);
  grey("noise", &view.noise);
  grey("shot_noise", &view.shot_noise);
  view.attenuation = NumberWithin(*map, "attenuation", 0.0, 100.0, view.attenuation);
  view.vignetting = NumberWithin(*map, "vignetting", 0.0, 1.0, view.vignetting);
  view.blur = NumberWithin(*map, "blur", 0.0, 20.0, view.blur);
  return view;
}

}  // namespace

Film ReadFilmFile(const std::filesystem::path& path) { return ParseFilmFile(path, ReadFile(path)); }

Film ParseFilmFile(const std::filesystem::path& path, const std::string& text) {
  const YamlMap file = ParseYaml(path.string(), text);
  const std::filesystem::path folder = path.parent_path();
  Film film;
  film.camera_file = folder / file.String("camera");
  film.tags_file = folder / file.String("tags");
  film.mount_file = folder / file.String("mount");
  film.rig.camera = ReadCameraFile(film.camera_file);
  film.rig.map = ReadTagsFile(film.tags_file);
  film.rig.body_from_camera = ReadMountFile(film.mount_file);
  const std::string true_tags = file.String("true_tags", "");
  film.true_map = true_tags.empty() ? film.rig.map : ReadTagsFile(folder / true_tags);

  film.sampling.rate = NumberWithin(file, "rate", 0.1, 1000.0, 10.0);
  film.sampling.jitter =
      NumberWithin(file, "jitter", 0.0, 0.4 / film.sampling.rate, film.sampling.jitter);
  film.exposure = NumberWithin(file, "exposure", 0.0, 1.0 / film.sampling.rate, film.exposure);
  if (const auto hold = file.OptionalMap("hold")) {
    film.hold_position = NumberWithin(*hold, "position", 0.0, 10.0, 0.0);
    film.hold_angle = NumberWithin(*hold, "angle", 0.0, 1.0, 0.0);
  }
  film.corner_sigma = NumberWithin(file, "corner_sigma", 0.0, 100.0, film.corner_sigma);
  if (const auto outliers = file.OptionalMap("outliers")) {
    film.outlier_probability = NumberWithin(*outliers, "probability", 0.0, 1.0);
    film.outlier_size = NumberWithin(*outliers, "size", 0.0, 1e4, film.outlier_size);
  }
  film.view = ReadView(file.OptionalMap("water"));
  file.Finish();
  return film;
}

}  // namespace fathom
