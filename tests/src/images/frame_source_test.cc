// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/images/frame_source.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/images/image_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "error_from.h"
#include "rendered_scene.h"
#include "test_folder.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

namespace fathom {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

CameraModel SmallCamera() {
  CameraModel camera = PlainCamera();
  camera.width = kWidth;
  camera.height = kHeight;
  return camera;
}

// A slope with some texture, different for each frame.
cv::Mat Picture(int frame) {
  cv::Mat picture(kHeight, kWidth, CV_8U);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      picture.at<uchar>(v, u) =
          static_cast<uchar>((u * 3 + v * 2 + 7 * frame + (u * v) % 11) % 256);
    }
  }
  return picture;
}

// Of the grey values, on average; the pictures of neighbouring frames have one of 7 and more.
double DifferenceOf(const GrayImage& image, const cv::Mat& picture) {
  double sum = 0.0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      sum += std::abs(int{image.At(u, v)} - int{picture.at<uchar>(v, u)});
    }
  }
  return sum / (kWidth * kHeight);
}

std::string Encoded(const cv::Mat& picture, const char* extension) {
  std::vector<uchar> bytes;
  cv::imencode(extension, picture, bytes);
  return {bytes.begin(), bytes.end()};
}

class FrameFolder : public testing::Test {
 protected:
  // frames.csv and its images, 0.5 s apart.
  void WriteImages(int num, const char* extension) const {
    std::string list = "t,file\n";
    for (int i = 0; i < num; ++i) {
      WriteFile(folder_ / fmt::format("{}{}", i, extension), Encoded(Picture(i), extension));
      list += fmt::format("{},{}{}\n", 0.5 * i, i, extension);
    }
    WriteFile(folder_ / "frames.csv", list);
  }

  // A video of lossless or nearly lossless frames, 8 per second.
  void WriteVideo(int num, const char* file = "film.avi", const char* code = "MJPG") const {
    cv::VideoWriter writer((folder_ / file).string(),
                           cv::CAP_FFMPEG,
                           cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]),
                           8.0,
                           cv::Size(kWidth, kHeight),
                           false);
    ASSERT_TRUE(writer.isOpened());
    for (int i = 0; i < num; ++i) writer.write(Picture(i));
  }

  // Makes zeros of the packets of film.avi that hold these frames: nothing that can be decoded.
  void DamageFrames(const std::vector<int>& frames) const {
    std::string bytes = ReadFile(folder_ / "film.avi");
    std::size_t at = bytes.find("movi");
    int frame = 0;
    for (const int damaged : frames) {
      for (; frame <= damaged; ++frame) at = bytes.find("00dc", at + 4);
      const auto* size = reinterpret_cast<const unsigned char*>(&bytes[at + 4]);
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 8, size[0] + 256 * size[1], 0);
    }
    WriteFile(folder_ / "film.avi", bytes);
  }

  // frame_times.csv, not evenly spaced: t = 100 + i^2 / 10.
  void WriteTimes(int num) const {
    std::string times = "frame,t\n";
    for (int i = 0; i < num; ++i) times += fmt::format("{},{}\n", i, 100.0 + 0.1 * i * i);
    WriteFile(folder_ / "frame_times.csv", times);
  }

  std::unique_ptr<FrameSource> Open(const std::string& video = "",
                                    const CameraModel& camera = SmallCamera()) const {
    return OpenFrames(folder_, {video, video_start_}, camera, (folder_ / "camera.yaml").string());
  }

  std::string RefusalOf(const std::string& video = "",
                        const CameraModel& camera = SmallCamera()) const {
    return ErrorFrom([&] {
      const auto source = Open(video, camera);
      for (ImageFrame frame; source->Next(&frame);) {
      }
    });
  }

  std::string Path(const char* file) const { return (folder_ / file).string(); }

  static std::vector<double> TimesOf(FrameSource& source) {
    std::vector<double> times;
    for (ImageFrame frame; source.Next(&frame);) times.push_back(frame.time);
    return times;
  }

  const std::filesystem::path folder_ = EmptyTestFolder();
  double video_start_ = 0.0;
};

TEST_F(FrameFolder, ReadsImagesWithTheirStamps) {
  for (const char* extension : {".png", ".pgm", ".jpg"}) {
    WriteImages(3, extension);
    const auto source = Open();
    EXPECT_EQ(source->num_expected(), 3);
    EXPECT_DOUBLE_EQ(source->mean_rate(), 2.0);
    ImageFrame frame;
    for (int i = 0; i < 3; ++i) {
      ASSERT_TRUE(source->Next(&frame)) << extension;
      EXPECT_EQ(frame.time, 0.5 * i);
      EXPECT_EQ(frame.name, Path(fmt::format("{}{}", i, extension).c_str()));
      ASSERT_EQ(frame.image.width, kWidth);
      // JPEG at OpenCV's quality of 95 moves a few grey values.
      EXPECT_NEAR(frame.image.At(20, 30),
                  Picture(i).at<uchar>(30, 20),
                  extension == std::string(".jpg") ? 25 : 0);
    }
    EXPECT_FALSE(source->Next(&frame));
    EXPECT_EQ(source->num_unreadable(), 0);
  }
}

TEST_F(FrameFolder, CountsDamagedAndMissingImagesAndGoesOn) {
  WriteImages(5, ".jpg");
  const std::string whole = ReadFile(folder_ / "1.jpg");
  WriteFile(folder_ / "1.jpg", whole.substr(0, whole.size() / 2));
  std::filesystem::remove(folder_ / "2.jpg");
  WriteFile(folder_ / "3.jpg", "no image at all");
  const auto source = Open();
  EXPECT_EQ(TimesOf(*source), (std::vector<double>{0.0, 2.0}));
  EXPECT_EQ(source->num_unreadable(), 3);
  ASSERT_EQ(source->unreadable().size(), 3u);
  EXPECT_THAT(source->unreadable()[0],
              testing::StartsWith(Path("frames.csv") + ":3: " + Path("1.jpg") +
                                  ": cannot decode this image: "));
  EXPECT_EQ(
      source->unreadable()[1],
      Path("frames.csv") + ":4: " + Path("2.jpg") + ": there is no such file. Check the path.");
  EXPECT_EQ(source->unreadable()[2],
            Path("frames.csv") + ":5: " + Path("3.jpg") +
                ": is no image, expected JPEG, PNG, PGM, PPM, TIFF or BMP.");
}

TEST_F(FrameFolder, ReadsEveryFormatThatItsRefusalNames) {
  for (const char* extension : {".png", ".pgm", ".ppm", ".tiff", ".bmp", ".jpg"}) {
    cv::Mat colours;
    cv::merge(std::vector<cv::Mat>(3, Picture(0)), colours);  // three of the same: grey
    const bool has_colours = extension == std::string(".ppm");
    const GrayImage image =
        DecodeImage("a", Encoded(has_colours ? colours : Picture(0), extension));
    ASSERT_EQ(image.width, kWidth) << extension;
    EXPECT_NEAR(
        image.At(20, 30), Picture(0).at<uchar>(30, 20), extension == std::string(".jpg") ? 25 : 0)
        << extension;
  }
}

// GDCM, which OpenCV would ask, ends the program on it; found by fuzzing.
TEST_F(FrameFolder, RefusesDamagedDicom) {
  for (const char* start : {"\xff\x4f\xff\x51", "P4\xd6\x6c"}) {
    const std::string bytes = start + std::string(124, '\xff') + "DICM\x03/";
    EXPECT_THROW(DecodeImage("a", bytes), InputError);
  }
}

// Cut at many places, and with bytes changed amid the data: never a picture that is not the file's.
TEST_F(FrameFolder, NeverTakesADamagedFileForAPicture) {
  for (const char* extension : {".png", ".jpg", ".pgm"}) {
    const std::string whole = Encoded(Picture(0), extension);
    for (std::size_t share = 1; share <= 9; ++share) {
      EXPECT_THROW(DecodeImage("a", whole.substr(0, whole.size() * share / 10)), InputError)
          << extension << " " << share;
    }
  }
  std::string png = Encoded(Picture(0), ".png");
  png[png.size() / 2] ^= 0x40;
  EXPECT_THROW(DecodeImage("a", png), InputError);
}

TEST_F(FrameFolder, RefusesImagesOfAnotherSizeThanTheCalibration) {
  WriteImages(2, ".png");
  CameraModel camera = SmallCamera();
  camera.width = 80;
  EXPECT_EQ(RefusalOf("", camera),
            Path("0.png") + ": is 64 x 48 pixels, expected 80 x 48 as in " + Path("camera.yaml") +
                ". Calibrate the camera at the size of its frames, or give the calibration that "
                "belongs to them.");
}

TEST_F(FrameFolder, RefusesImagesOfSixteenBits) {
  cv::Mat deep;
  Picture(0).convertTo(deep, CV_16U, 16.0);
  EXPECT_EQ(ErrorFrom([&] { DecodeImage("deep.png", Encoded(deep, ".png")); }),
            "deep.png: has more than 8 bits per pixel, expected 8. Convert it with a "
            "scale that is the same for all images.");
}

TEST_F(FrameFolder, ReadsAVideoWithTheContainersStamps) {
  WriteVideo(9);
  const auto source = Open("film.avi");
  EXPECT_EQ(source->num_expected(), 9);
  EXPECT_NEAR(source->mean_rate(), 8.0, 1e-9);
  ImageFrame frame;
  for (int i = 0; i < 9; ++i) {
    ASSERT_TRUE(source->Next(&frame));
    EXPECT_NEAR(frame.time, i / 8.0, 1e-6);
    EXPECT_EQ(frame.name, Path("film.avi") + fmt::format(", frame {}", i));
    // Motion JPEG: texture comes back within some grey values.
    EXPECT_NEAR(frame.image.At(20, 30), Picture(i).at<uchar>(30, 20), 30) << i;
  }
  EXPECT_FALSE(source->Next(&frame));
  EXPECT_EQ(source->num_unreadable(), 0);
}

// A camera that is mounted upside down may say in the container how to show its pictures; the
// calibration is of the sensor's pixels.
TEST_F(FrameFolder, LeavesAVideoAsTheSensorSawIt) {
  WriteVideo(3, "film.mp4", "mp4v");
  const auto first_pixels = [&] {
    ImageFrame frame;
    EXPECT_TRUE(Open("film.mp4")->Next(&frame));
    return frame.image.pixels;
  };
  const auto before = first_pixels();
  // Half a turn in the track header's matrix, numbers of 16 + 16 bits, the highest byte first.
  std::string bytes = ReadFile(folder_ / "film.mp4");
  const std::size_t matrix = bytes.find("tkhd") + 4 + 40;
  const std::string minus_one = "\xff\xff" + std::string(2, '\0');
  for (const std::size_t diagonal : {0, 4}) bytes.replace(matrix + 4 * diagonal, 4, minus_one);
  WriteFile(folder_ / "film.mp4", bytes);
  cv::VideoCapture peer((folder_ / "film.mp4").string(), cv::CAP_FFMPEG);
  EXPECT_EQ(std::abs(peer.get(cv::CAP_PROP_ORIENTATION_META)), 180.0);
  EXPECT_EQ(first_pixels(), before);
}

TEST_F(FrameFolder, PrefersTheStampsOfFrameTimes) {
  WriteVideo(3);
  WriteFile(folder_ / "frame_times.csv", "frame,t\n0,100.5\n1,100.7\n2,100.8\n");
  const auto source = Open("film.avi");
  EXPECT_EQ(TimesOf(*source), (std::vector<double>{100.5, 100.7, 100.8}));
  EXPECT_NEAR(source->mean_rate(), 2.0 / 0.3, 1e-9);
}

TEST_F(FrameFolder, CountsTheContainersStampsFromTheStartOfTheVideo) {
  WriteVideo(3);
  video_start_ = 1433350639.5;
  const auto times = TimesOf(*Open("film.avi"));
  ASSERT_EQ(times.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(times[i], 1433350639.5 + i / 8.0, 1e-6);
  WriteFile(folder_ / "frame_times.csv", "frame,t\n0,100.5\n1,100.7\n2,100.8\n");
  EXPECT_EQ(RefusalOf("film.avi"),
            Path("frame_times.csv") +
                ": stands beside log.yaml's video_start, expected one of them to say when the "
                "frames were taken.");
}

TEST_F(FrameFolder, CountsWhatATruncatedVideoLacks) {
  WriteVideo(40);
  const std::string whole = ReadFile(folder_ / "film.avi");
  WriteFile(folder_ / "film.avi", whole.substr(0, whole.size() / 2));
  std::string times = "frame,t\n";
  for (int i = 0; i < 40; ++i) times += fmt::format("{},{}\n", i, i / 8.0);
  WriteFile(folder_ / "frame_times.csv", times);
  const auto source = Open("film.avi");
  const int num_read = static_cast<int>(TimesOf(*source).size());
  EXPECT_GT(num_read, 10);
  EXPECT_LT(num_read, 30);
  EXPECT_EQ(source->num_unreadable(), 40 - num_read);
  ASSERT_EQ(source->unreadable().size(), 1u);
  EXPECT_EQ(
      source->unreadable()[0],
      fmt::format("{}: ends after {} frames, expected 40 as {} lists. The video is cut off or "
                  "damaged.",
                  Path("film.avi"),
                  num_read,
                  Path("frame_times.csv")));
}

TEST_F(FrameFolder, RefusesAVideoThatCannotBeOpened) {
  WriteFile(folder_ / "film.mp4", "no video at all");
  EXPECT_EQ(RefusalOf("film.mp4"),
            Path("film.mp4") +
                ": cannot be opened as a video. It is damaged, cut off (an MP4 has its index at "
                "the end), or of a format that FFmpeg does not know.");
  EXPECT_EQ(RefusalOf("other.mp4"), Path("other.mp4") + ": there is no such file. Check the path.");
}

TEST_F(FrameFolder, RefusesMoreFramesThanStamps) {
  WriteVideo(4);
  WriteFile(folder_ / "frame_times.csv", "frame,t\n0,1\n1,2\n2,3\n");
  EXPECT_EQ(RefusalOf("film.avi"),
            Path("film.avi") + ": frame 3 has no stamp: " + Path("frame_times.csv") +
                " ends at frame 2. Expected a row for each of the 4 frames.");
}

// The picture says which frame it really is.
TEST_F(FrameFolder, GivesFramesTheirOwnStampsBehindOnesThatCannotBeDecoded) {
  WriteVideo(10);
  DamageFrames({0, 3, 5, 6, 9});
  for (const bool has_times : {false, true}) {
    if (has_times) WriteTimes(10);
    const auto source = Open("film.avi");
    EXPECT_EQ(source->num_expected(), 10);
    ImageFrame frame;
    for (const int i : {1, 2, 4, 7, 8}) {
      ASSERT_TRUE(source->Next(&frame));
      EXPECT_NEAR(frame.time, has_times ? 100.0 + 0.1 * i * i : i / 8.0, 1e-6);
      EXPECT_EQ(frame.name, Path("film.avi") + fmt::format(", frame {}", i));
      EXPECT_LT(DifferenceOf(frame.image, Picture(i)), 3.5) << i;
    }
    EXPECT_FALSE(source->Next(&frame));
    EXPECT_EQ(source->num_unreadable(), 5);
    const auto problem = [&](const char* frames) {
      return fmt::format(
          "{}: {} cannot be decoded. The video is damaged there.", Path("film.avi"), frames);
    };
    EXPECT_THAT(
        source->unreadable(),
        testing::ElementsAre(
            problem("frame 0"), problem("frame 3"), problem("frames 5 to 6"), problem("frame 9")));
  }
}

// H.264 stores frames behind those that they rest on.
TEST_F(FrameFolder, GivesFramesThatAreStoredOutOfOrderTheirOwnStamps) {
  WriteVideo(10, "film.mp4", "avc1");
  WriteTimes(10);
  const auto source = Open("film.mp4");
  ImageFrame frame;
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(source->Next(&frame));
    EXPECT_NEAR(frame.time, 100.0 + 0.1 * i * i, 1e-6);
    EXPECT_LT(DifferenceOf(frame.image, Picture(i)), 3.5) << i;
  }
  EXPECT_FALSE(source->Next(&frame));
  EXPECT_TRUE(source->unreadable().empty());
}

// The length of the stream stands 32 bytes into its header.
TEST_F(FrameFolder, ReadsTheFramesThatAHeaderDoesNotCount) {
  WriteVideo(10);
  std::string bytes = ReadFile(folder_ / "film.avi");
  char& length = bytes[bytes.find("strh") + 8 + 32];
  ASSERT_EQ(length, 10);
  length = 3;
  WriteFile(folder_ / "film.avi", bytes);
  const auto source = Open("film.avi");
  EXPECT_EQ(source->num_expected(), 10);
  EXPECT_EQ(TimesOf(*source).size(), 10u);
  EXPECT_EQ(source->num_unreadable(), 0);
  EXPECT_TRUE(source->unreadable().empty());
}

// A count guessed from duration and rate is wrong for most (90 000 for the TS).
TEST_F(FrameFolder, CountsTheFramesOfContainersThatDoNot) {
  for (const char* file : {"film.mkv", "film.ts"}) {
    WriteVideo(9, file, "mp4v");
    const auto source = Open(file);
    EXPECT_EQ(source->num_expected(), 9) << file;
    const auto times = TimesOf(*source);
    ASSERT_EQ(times.size(), 9u) << file;
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(times[i], i / 8.0, 1e-3) << file;
    EXPECT_TRUE(source->unreadable().empty()) << file;
  }
}

TEST_F(FrameFolder, SaysWhereAContainerThatCountsNoFramesIsCutOff) {
  WriteVideo(40, "film.mkv");
  const std::string whole = ReadFile(folder_ / "film.mkv");
  WriteFile(folder_ / "film.mkv", whole.substr(0, whole.size() / 2));
  const auto source = Open("film.mkv");
  const auto times = TimesOf(*source);
  EXPECT_GT(times.size(), 10u);
  EXPECT_LT(times.size(), 30u);
  EXPECT_EQ(source->num_expected(), static_cast<int>(times.size()));
  EXPECT_EQ(source->num_unreadable(), 0);
  EXPECT_THAT(source->unreadable(),
              testing::ElementsAre(fmt::format(
                  "{}: ends at {:.1f} s, expected about 5.0 s as its header says. The video may be "
                  "cut off; how many frames are missing is not known.",
                  Path("film.mkv"),
                  times.back())));
}

// The stamp of a block stands behind its track's number, in ms.
TEST_F(FrameFolder, RefusesStampsOfAContainerThatDoNotRise) {
  WriteVideo(4, "film.mkv");
  std::string bytes = ReadFile(folder_ / "film.mkv");
  const std::string second = {'\x81', '\x00', '\x7d', '\x80'};
  const std::string third = {'\x81', '\x00', '\xfa', '\x80'};
  const std::size_t at = bytes.find(third);
  ASSERT_NE(at, std::string::npos);
  WriteFile(folder_ / "film.mkv", bytes.replace(at, third.size(), second));
  EXPECT_EQ(RefusalOf("film.mkv"),
            Path("film.mkv") +
                ", frame 2: the container stamps it 0.125 s, the frame before 0.125 s; expected "
                "rising stamps. Write them to " +
                Path("frame_times.csv") + ".");
}

TEST_F(FrameFolder, SaysWhatItDoesNotRead) {
  WriteImages(2, ".png");
  EXPECT_TRUE(Open()->remarks().empty());
  WriteFile(folder_ / "frames.csv", "t,file,gain\n0,0.png,1\n1,1.png,1\n");
  WriteTimes(2);
  EXPECT_THAT(Open()->remarks(),
              testing::ElementsAre("frames.csv: 1 further column is not read: gain.",
                                   Path("frame_times.csv") +
                                       ": is not read, because it is for a video and log.yaml "
                                       "names none."));
  std::filesystem::remove(folder_ / "frames.csv");
  WriteVideo(2);
  WriteFile(folder_ / "frame_times.csv", "frame,t,gain\n0,0,1\n1,1,1\n");
  EXPECT_THAT(Open("film.avi")->remarks(),
              testing::ElementsAre("frame_times.csv: 1 further column is not read: gain."));
}

TEST_F(FrameFolder, RefusesAFolderWithoutImagesOrWithBoth) {
  EXPECT_EQ(RefusalOf(),
            folder_.string() +
                ": holds no images: no frames.csv, and log.yaml names no video. See "
                "docs/file_formats.md.");
  WriteImages(2, ".png");
  EXPECT_EQ(RefusalOf("film.avi"),
            folder_.string() +
                ": holds frames.csv, and log.yaml names the video film.avi; expected one of them. "
                "Remove the other.");
}

}  // namespace
}  // namespace fathom
