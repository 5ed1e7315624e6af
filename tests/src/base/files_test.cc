// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/exists.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "error_from.h"
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fathom {
namespace {

// Of the running test: others run beside it.
std::filesystem::path Folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(FATHOM_SCRATCH_DIR) / "files_test" / test->name();
}

TEST(Files, GiveBackEveryByteThatWasWritten) {
  std::filesystem::remove_all(Folder());
  std::string content("a\r\n\0\xff", 5);
  content += std::string(100000, 'x');
  WriteFile(Folder() / "deep" / "er" / "file", content);
  EXPECT_EQ(ReadFile(Folder() / "deep" / "er" / "file"), content);
}

TEST(Files, AnEmptyFileIsReadAsEmpty) {
  WriteFile(Folder() / "empty", "");
  EXPECT_EQ(ReadFile(Folder() / "empty"), "");
}

TEST(Files, WritingOverAFolderIsRefusedAndLeavesNothingBehind) {
  const auto folder = Folder() / "parent" / "child";
  std::filesystem::create_directories(folder / "content");
  try {
    WriteFile(folder, "x");
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find(folder.string() + ": cannot write this file: "), 0u)
        << error.what();
  }
  for (const auto& entry : std::filesystem::directory_iterator(Folder() / "parent")) {
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
  std::filesystem::create_directories(Folder());
  const auto link = Folder() / "link", pipe = Folder() / "unread_pipe",
             around = Folder() / "around";
  for (const auto& path : {link, pipe, around}) std::filesystem::remove(path);
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
  std::filesystem::create_directories(Folder());
  const auto pipe = Folder() / "pipe";
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  RequireWritableFile(pipe);
  std::string seen;
  std::thread reader([&] { std::getline(std::ifstream(pipe), seen); });
  WriteFile(pipe, "through");
  reader.join();
  EXPECT_EQ(seen, "through");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

}  // namespace
}  // namespace fathom
