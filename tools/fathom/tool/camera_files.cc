// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/camera_files.h"

#include "fathom/base/files/leaves_its_folder.h"
#include "fathom/base/input_error.h"
#include "fathom/camera/camera_file.h"
#include "fathom/camera/mount_file.h"
#include "fathom/camera/tags_file.h"
#include "fathom/images/video_reader.h"

#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

// Reads one of the map's camera files. What is called otherwise than such a file, or is a link out
// of the map's folder, may be anybody's: no line of it stands in a message.
template <typename Read>
void RequireCameraFile(const std::filesystem::path& file,
                       const std::filesystem::path& folder,
                       const char* key,
                       const char* what,
                       const Read& read) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw InputError(
        fmt::format("{}: is not there. The map's camera names it as '{}'.", file.string(), key));
  }
  const auto real = std::filesystem::weakly_canonical(file, error);
  const auto inside = std::filesystem::weakly_canonical(folder / ".", error);
  const bool is_own = real.extension() == ".yaml" || real.extension() == ".yml";
  try {
    read(file);
  } catch (const InputError&) {
    if (is_own && !LeavesItsFolder(real.lexically_relative(inside))) throw;
    throw InputError(fmt::format("{}: is no {}, expected one: the map's camera names it as '{}'.",
                                 file.string(),
                                 what,
                                 key));
  }
}

}  // namespace

void RequireCameraFiles(const CameraMap& camera, const std::filesystem::path& from) {
  using Path = std::filesystem::path;
  RequireCameraFile(from / camera.video, from, "video", "video", [](const Path& file) {
    const VideoReader video(file);
  });
  RequireCameraFile(from / camera.calibration,
                    from,
                    "calibration",
                    "calibration of a camera",
                    [](const Path& file) { ReadCameraFile(file); });
  RequireCameraFile(from / camera.tags, from, "tags", "file of tags", [](const Path& file) {
    ReadTagsFile(file);
  });
  RequireCameraFile(from / camera.mount, from, "mount", "mount of a camera", [](const Path& file) {
    ReadMountFile(file);
  });
}

void TakeCameraFiles(const CameraMap& camera,
                     const std::filesystem::path& from,
                     const std::filesystem::path& to) {
  for (const auto& [in_log, named] : camera.Files()) {
    const std::filesystem::path file = from / named;
    std::error_code error;
    if (in_log == camera.Files().front().first) {
      std::filesystem::create_hard_link(file, to / in_log, error);
      if (!error) continue;
    }
    if (!std::filesystem::copy_file(file, to / in_log, error)) {
      throw InputError(
          fmt::format("{}: cannot be copied into the log: {}. The map's camera names it.",
                      file.string(),
                      error.message()));
    }
  }
}

}  // namespace fathom
