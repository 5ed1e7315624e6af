// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/overlay.h"

#include "fathom/base/input_error.h"
#include "fathom/images/image_file.h"
#include "fathom/images/video_reader.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "test_folder.h"
#include <gmock/gmock.h>
#include <sys/resource.h>

namespace fathom {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

class Overlay : public testing::Test {
 protected:
  // A video or sheet of so many frames whose texture takes some kilobytes each.
  void Draw(const std::string& file, int num_frames) const {
    const auto overlay = OpenOverlay(folder_ / file, kWidth, kHeight, 8.0);
    GrayImage image(kWidth, kHeight);
    unsigned bits = 1;
    for (int i = 0; i < num_frames; ++i) {
      for (std::uint8_t& grey : image.pixels) grey = (bits = 1664525u * bits + 1013904223u) >> 24;
      OverlayFrame frame;
      frame.image = &image;
      overlay->Add(frame);
    }
    overlay->Finish();
  }

  int NumFiles() const {
    int num = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++num;
    return num;
  }

  const std::filesystem::path folder_ = EmptyTestFolder();
};

using OverlayDeathTest = Overlay;

TEST_F(Overlay, HoldsEveryFrameOfAVideo) {
  for (const char* file : {"a.mp4", "a.avi"}) {
    Draw(file, 5);
    VideoReader reader(folder_ / file);
    int num = 0;
    for (GrayImage image; reader.Next(&image); ++num) EXPECT_EQ(image.width, kWidth);
    EXPECT_EQ(num, 5) << file;
    EXPECT_NEAR(reader.mean_rate(), 8.0, 1e-6) << file;
  }
  EXPECT_EQ(NumFiles(), 2);
}

TEST_F(Overlay, RefusesToBeMadeOfNoFrame) {
  for (const char* file : {"a.png", "a.mp4", "a.avi"}) {
    EXPECT_THAT([&] { Draw(file, 0); },
                testing::ThrowsMessage<InputError>(
                    (folder_ / file).string() +
                    ": cannot be made of no frame, expected one at least that can be read."));
  }
  EXPECT_EQ(NumFiles(), 0);
}

TEST_F(Overlay, TakesTwelveFramesForASheetHoweverMany) {
  const auto sheet = OpenOverlay(folder_ / "a.png", kWidth, kHeight, 8.0);
  for (const int num_frames : {0, 12, 13, 1000, 1'000'000'000}) {
    int num = 0;
    for (int i = 0; i < 1000; ++i) num += sheet->Wants(i, num_frames) ? 1 : 0;
    EXPECT_EQ(num, num_frames == 1'000'000'000 ? 1 : 12) << num_frames;
  }
  EXPECT_TRUE(sheet->Wants(999'999'999, 1'000'000'000));
}

// A limit on the size of files in place of a full disk, in a process of its own, which then ends.
TEST_F(Overlay, MakesACaptionFitThePicture) {
  const GrayImage image(kWidth, kHeight);
  OverlayFrame frame;
  frame.image = &image;
  frame.caption = "t 1234.50 s, 12 tags, x -12.34 y -12.34 z -12.34 m, rms 12.34 px";
  const auto overlay = OpenOverlay(folder_ / "sheet.png", kWidth, kHeight, 8.0);
  overlay->Add(frame);
  overlay->Finish();
  const GrayImage sheet = ReadImage(folder_ / "sheet.png");
  int last = 0;
  for (int v = 0; v < 18; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      if (sheet.pixels[static_cast<std::size_t>(v * sheet.width + u)] > 60)
        last = std::max(last, u);
    }
  }
  EXPECT_GT(last, kWidth * 3 / 4);
  EXPECT_LT(last, kWidth - 4);
}

TEST_F(OverlayDeathTest, NamesAVideoThatIsNotWrittenInFull) {
  for (const char* file : {"a.mp4", "a.avi"}) {
    const auto draw = [&] {
      const rlimit limit = {.rlim_cur = 30000, .rlim_max = 30000};
      setrlimit(RLIMIT_FSIZE, &limit);
      std::signal(SIGXFSZ, SIG_IGN);
      try {
        Draw(file, 40);
      } catch (const InputError& error) {
        std::fprintf(stderr, "%s", error.what());
        std::_Exit(1);
      }
      std::_Exit(0);
    };
    EXPECT_EXIT(draw(),
                testing::ExitedWithCode(1),
                (folder_ / file).string() +
                    ": cannot write this video: [0-9]* of its 40 frames are in the file. Is the "
                    "disk full.");
  }
  EXPECT_EQ(NumFiles(), 0);
}

}  // namespace
}  // namespace fathom
