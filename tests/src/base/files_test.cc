// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"

#include <filesystem>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fathom {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(FATHOM_SCRATCH_DIR) / "files_test";

TEST(Files, GiveBackEveryByteThatWasWritten) {
  std::filesystem::remove_all(kFolder);
  std::string content("a\r\n\0\xff", 5);
  content += std::string(100000, 'x');
  WriteFile(kFolder / "deep" / "er" / "file", content);
  EXPECT_EQ(ReadFile(kFolder / "deep" / "er" / "file"), content);
}

TEST(Files, AnEmptyFileIsReadAsEmpty) {
  WriteFile(kFolder / "empty", "");
  EXPECT_EQ(ReadFile(kFolder / "empty"), "");
}

TEST(Files, WritingOverAFolderIsRefusedAndLeavesNothingBehind) {
  const auto folder = kFolder / "parent" / "child";
  std::filesystem::create_directories(folder / "content");
  try {
    WriteFile(folder, "x");
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find(folder.string() + ": cannot write this file: "), 0u)
        << error.what();
  }
  for (const auto& entry : std::filesystem::directory_iterator(kFolder / "parent")) {
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

TEST(Files, AreWrittenIntoAPipeNotInItsPlace) {
  std::filesystem::create_directories(kFolder);
  const auto pipe = kFolder / "pipe";
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  RequireWritableFile(pipe);
  std::string seen;
  std::thread reader([&] { seen = ReadFile(pipe); });
  WriteFile(pipe, "through");
  reader.join();
  EXPECT_EQ(seen, "through");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

}  // namespace
}  // namespace fathom
