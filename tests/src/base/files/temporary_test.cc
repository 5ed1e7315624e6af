// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/temporary.h"

#include "fathom/base/files/input_file.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "test_folder.h"
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

class TemporaryTest : public ::testing::Test {
 protected:
  // Another process, which has written a folder and is then sent `signal`; its status.
  int StatusOfInterrupted(int signal) const {
    const pid_t child = fork();
    if (child == 0) {
      RemoveTemporariesOnInterrupt();
      const Temporary temporary(folder_ / "log");
      fs::create_directories(temporary.path());
      std::ofstream(temporary.path() / "velocity.csv") << "t,u\n";
      kill(getpid(), signal);
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      _exit(fs::exists(temporary.path()) ? 77 : 78);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }

  const fs::path folder_ = EmptyTestFolder();
};

TEST_F(TemporaryTest, KeepsTheEndingThatWritersGoBy) {
  const Temporary temporary(folder_ / "dive.mp4");
  EXPECT_EQ(temporary.path().extension(), ".mp4");
  EXPECT_EQ(temporary.path().parent_path(), folder_);
  EXPECT_NE(temporary.path(), folder_ / "dive.mp4");
}

TEST_F(TemporaryTest, LeavesNothingBehindThatTookNoPlace) {
  {
    const Temporary temporary(folder_ / "log");
    fs::create_directories(temporary.path() / "frames");
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(TemporaryTest, AFolderReplacesTheOneThatWasThere) {
  fs::create_directories(folder_ / "log");
  std::ofstream(folder_ / "log" / "old") << "old";
  const Temporary temporary(folder_ / "log");
  fs::create_directories(temporary.path());
  std::ofstream(temporary.path() / "new") << "new";
  temporary.TakePlace();
  EXPECT_TRUE(fs::exists(folder_ / "log" / "new"));
  EXPECT_FALSE(fs::exists(folder_ / "log" / "old"));
}

TEST_F(TemporaryTest, OfASymbolicLinkTakesThePlaceItPointsTo) {
  std::ofstream(folder_ / "real") << "old";
  fs::create_symlink("real", folder_ / "link");
  const Temporary temporary(folder_ / "link");
  std::ofstream(temporary.path()) << "new";
  temporary.TakePlace();
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(ReadFile(folder_ / "real"), "new");
}

TEST_F(TemporaryTest, IsRemovedWhenTheProcessIsInterrupted) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int status = StatusOfInterrupted(signal);
    ASSERT_TRUE(WIFSIGNALED(status)) << status;
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_TRUE(fs::is_empty(folder_));
  }
}

TEST_F(TemporaryTest, StaysWhereTheSignalIsIgnored) {  // as under nohup
  const auto before = std::signal(SIGHUP, SIG_IGN);
  const int status = StatusOfInterrupted(SIGHUP);
  std::signal(SIGHUP, before);
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 77);
}

}  // namespace
}  // namespace fathom
