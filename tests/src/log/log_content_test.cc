// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_content.h"

#include "fathom/base/files/output_file.h"

#include <filesystem>
#include <set>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

class LogContent : public testing::Test {
 protected:
  void SetUp() override {
    Write("log.yaml", "name: a\ndof: surge\nvehicle: ../rov.yaml\n");
    Write("command.csv", "t,tau_surge\n0,1\n1,2\n");
    Write("velocity.csv", "t,u\n0,1\n1,2\n");
    Write("../rov.yaml", "name: rov\n");
  }
  void Write(const std::string& name, const std::string& text) { WriteFile(log_ / name, text); }

  const fs::path folder_ = EmptyTestFolder(), log_ = folder_ / "log";
};

TEST_F(LogContent, IsOfTheFilesAndNotOfTheirPlace) {
  const std::string before = ContentOf(log_);
  EXPECT_EQ(before.size(), 32u);
  fs::copy(log_, folder_ / "copy");
  EXPECT_EQ(ContentOf(folder_ / "copy"), before);
}

TEST_F(LogContent, ChangesWithWhateverDecidesAResult) {
  std::set<std::string> contents = {ContentOf(log_)};
  for (const char* name : {"log.yaml",
                           "command.csv",
                           "velocity.csv",
                           "pose.csv",
                           "detections.csv",
                           "camera.yaml",
                           "tags.yaml",
                           "mount.yaml",
                           "../rov.yaml"}) {
    fs::path file = log_ / name;
    const std::string before =
        fs::exists(file) ? "name: a\nvehicle: ../rov.yaml\ndof: surge\n" : "";
    Write(name, before + "# " + name);
    EXPECT_TRUE(contents.insert(ContentOf(log_)).second) << name;
  }
  Write("notes.txt", "not read by anybody");
  EXPECT_FALSE(contents.insert(ContentOf(log_)).second);
}

TEST_F(LogContent, HoldsTheImages) {
  Write("frames.csv", "t,file\n0,frames/0.png\n");
  Write("frames/0.png", "one");
  const std::string before = ContentOf(log_);
  Write("frames/0.png", "two");
  EXPECT_NE(ContentOf(log_), before);
}

TEST_F(LogContent, TellsAFileFromItsContentInAnother) {
  Write("pose.csv", "x");
  const std::string before = ContentOf(log_);
  fs::rename(log_ / "pose.csv", log_ / "detections.csv");
  EXPECT_NE(ContentOf(log_), before);
}

TEST_F(LogContent, RefusesAPipeWithoutWaitingForIt) {
  const fs::path pipe = log_ / "pose.csv";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(ErrorFrom([&] { ContentOf(log_); }), pipe.string() + ": is a pipe, expected a file.");
}

TEST(Digest, TellsListsOfTextsApart) {
  EXPECT_NE(DigestOf(std::vector<std::string>{"a", "bc"}),
            DigestOf(std::vector<std::string>{"ab", "c"}));
  EXPECT_EQ(DigestOf("a"), DigestOf(std::vector<std::string>{"a"}));
}

}  // namespace
}  // namespace fathom
