// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/exists.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fathom {
namespace {

TEST(Files, GiveBackEveryByteThatWasWritten) {
  const auto file = EmptyTestFolder() / "deep" / "er" / "file";
  std::string content("a\r\n\0\xff", 5);
  content += std::string(100000, 'x');
  WriteFile(file, content);
  EXPECT_EQ(ReadFile(file), content);
}

TEST(Files, AnEmptyFileIsReadAsEmpty) {
  WriteFile(TestFolder() / "empty", "");
  EXPECT_EQ(ReadFile(TestFolder() / "empty"), "");
}

TEST(Files, WritingOverAFolderIsRefusedAndLeavesNothingBehind) {
  const auto folder = TestFolder() / "parent" / "child";
  std::filesystem::create_directories(folder / "content");
  EXPECT_THAT(ErrorFrom([&] { WriteFile(folder, "x"); }),
              testing::StartsWith(folder.string() + ": cannot write this file: "));
  for (const auto& entry : std::filesystem::directory_iterator(TestFolder() / "parent")) {
    EXPECT_EQ(entry.path(), folder);
  }
}

TEST(Files, ReplaceAFileInMemoryAsAnyOther) {
  const std::filesystem::path memory = "/dev/shm";
  if (!std::filesystem::is_directory(memory)) GTEST_SKIP() << "there is no /dev/shm";
  const auto file = memory / ("fathom_files_test" + std::to_string(getpid()));
  WriteFile(file, "first");
  WriteFile(file, "second");
  EXPECT_EQ(ReadFile(file), "second");
  std::filesystem::remove(file);
}

std::string WhyUnreadable(const std::filesystem::path& path) {
  return ErrorFrom([&] { ReadFile(path); });
}

// A device may never end, a pipe never begin.
TEST(Files, AreReadFromFilesAlone) {
  const auto folder = EmptyTestFolder();
  const auto link = folder / "link", pipe = folder / "unread_pipe", around = folder / "around";
  EXPECT_EQ(WhyUnreadable("/dev/zero"), "/dev/zero: is a device, expected a file.");
  std::filesystem::create_symlink("/dev/zero", link);
  EXPECT_EQ(WhyUnreadable(link), link.string() + ": is a device, expected a file.");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(WhyUnreadable(pipe), pipe.string() + ": is a pipe, expected a file.");
  std::filesystem::remove(link);
  std::filesystem::create_symlink("gone.csv", link);
  EXPECT_EQ(WhyUnreadable(link),
            link.string() + ": is a link to gone.csv, which is not there. Mend the link.");
  EXPECT_TRUE(Exists(link));
  std::filesystem::create_symlink("around", around);
  EXPECT_EQ(WhyUnreadable(around),
            around.string() + ": is a link to around, which is not there. Mend the link.");
}

TEST(Files, AreWrittenIntoAPipeNotInItsPlace) {
  const auto pipe = EmptyTestFolder() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  RequireWritableFile(pipe);
  std::string seen;
  std::thread reader([&] { std::getline(std::ifstream(pipe), seen); });
  WriteFile(pipe, "through");
  reader.join();
  EXPECT_EQ(seen, "through");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

// Each makes the folder to try, and takes it away again.
TEST(Files, MayBeTriedInOneNewFolderAtTheSameTime) {
  const auto folder = EmptyTestFolder() / "new";
  const auto try_often = [&](const char* name) {
    for (int i = 0; i < 500; ++i) RequireWritableFolder(folder / name);
  };
  std::thread other([&] { EXPECT_NO_THROW(try_often("a")); });
  EXPECT_NO_THROW(try_often("b"));
  other.join();
}

// The folders that would have to be made are not there: that is not what hinders.
TEST(OutputFile, SaysThatAFolderMayNotBeMade) {
  const std::filesystem::path folder = EmptyTestFolder();
  std::filesystem::permissions(folder, std::filesystem::perms(0555));
  constexpr uid_t kNobody = 65534;
  const bool is_root = geteuid() == 0;  // who may write everywhere
  if (is_root) {
    ASSERT_EQ(seteuid(kNobody), 0);
  }
  const std::string error =
      ErrorFrom([&] { RequireWritableFile(folder / "plan" / "command.csv"); });
  if (is_root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  std::filesystem::permissions(folder, std::filesystem::perms(0755));
  EXPECT_EQ(
      error,
      (folder / "plan" / "command.csv").string() + ": cannot write this file: Permission denied.");
}

}  // namespace
}  // namespace fathom
