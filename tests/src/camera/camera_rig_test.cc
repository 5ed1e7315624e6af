// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/camera_rig.h"

#include "fathom/base/files/output_file.h"

#include <map>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

const std::map<std::string, std::string> kFiles = {
    {"camera.yaml",
     "cam0: {camera_model: pinhole, distortion_model: none, intrinsics: [500, 510, 320, 240], "
     "resolution: [640, 480]}\n"},
    {"tags.yaml",
     "family: tag36h11\ntags: [{id: 4, size: 0.16, world_from_tag: {position: [2, 0, 0.5], "
     "quaternion: [0.5, 0.5, 0.5, 0.5]}}]\n"},
    {"mount.yaml",
     "body_from_camera: {position: [0.2, 0, 0.05], quaternion: [0.5, 0.5, 0.5, 0.5]}\n"}};

std::filesystem::path FolderWithout(const std::string& file) {
  const auto folder = EmptyTestFolder();
  for (const auto& [name, text] : kFiles) {
    if (name != file) WriteFile(folder / name, text);
  }
  return folder;
}

TEST(CameraRig, ReadsTheThreeFiles) {
  const CameraRig rig = ReadCameraRig(FolderWithout(""));
  EXPECT_EQ(rig.camera.fy, 510.0);
  ASSERT_NE(rig.map.Find(4), nullptr);
  // The camera looks ahead: its z axis is the body's x, its x the body's y.
  EXPECT_TRUE((rig.body_from_camera * Eigen::Vector3d(0.0, 0.0, 1.0))
                  .isApprox(Eigen::Vector3d(1.2, 0.0, 0.05)));
  EXPECT_TRUE((rig.body_from_camera * Eigen::Vector3d(1.0, 0.0, 0.0))
                  .isApprox(Eigen::Vector3d(0.2, 1.0, 0.05)));
}

TEST(CameraRig, SaysWhatIsMissing) {
  const std::map<std::string, std::string> meanings = {
      {"camera.yaml", "the camera's calibration"},
      {"tags.yaml", "size and place of the markers"},
      {"mount.yaml", "the camera's place on the vehicle"}};
  for (const auto& [file, meaning] : meanings) {
    const auto folder = FolderWithout(file);
    EXPECT_EQ(ErrorFrom([&] { ReadCameraRig(folder); }),
              folder.string() + ": holds no " + file + " (" + meaning +
                  "), expected it in a camera log. See docs/file_formats.md.");
  }
}

TEST(CameraRig, NamesAllThatIsMissingAtOnce) {
  const auto folder = FolderWithout("mount.yaml");
  std::filesystem::remove(folder / "camera.yaml");
  EXPECT_EQ(ErrorFrom([&] { RequireRigFiles(folder, {"images (frames.csv)"}); }),
            folder.string() +
                ": holds no camera.yaml (the camera's calibration), no mount.yaml (the camera's "
                "place on the vehicle), no images (frames.csv), expected them in a camera log. "
                "See docs/file_formats.md.");
}

// What else is missing is said by who misses it.
TEST(CameraRig, IsNotMissedForImagesAlone) {
  EXPECT_NO_THROW(RequireRigFiles(FolderWithout(""), {"images (frames.csv)"}));
}

}  // namespace
}  // namespace fathom
