// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/print_text.h"

#include "fathom/tool/wrapped_text.h"

#include <array>
#include <cstdio>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

namespace fathom {
namespace {

TEST(WrappedText, AreBrokenBetweenWordsAndIndented) {
  EXPECT_EQ(WrappedText("note: a line of many words\nshort\n", 16),
            "note: a line of\n  many words\nshort\n");
  EXPECT_EQ(WrappedText("no newline at the end", 16), "no newline at\n  the end");
}

TEST(WrappedText, HangBehindTheGapBeforeTheSentence) {
  EXPECT_EQ(WrappedText("red  gap  four gaps of over five steps", 25),
            "red  gap  four gaps of\n          over five steps");
  EXPECT_EQ(WrappedText("      To do: find out why it paused", 24),
            "      To do: find out\n      why it paused");
}

TEST(WrappedText, KeepAWordThatIsLonger) {
  EXPECT_EQ(WrappedText("see /a/very/long/path.csv there", 10),
            "see\n  /a/very/long/path.csv\n  there");
  EXPECT_EQ(WrappedText("/a/very/long/path.csv", 10), "/a/very/long/path.csv");
}

TEST(WrappedText, LeaveTablesWhole) {
  const std::string table =
      "log of a dive  inertia\n"
      "-------------  -------\n"
      "a long path    1 ± 2\n"
      "another path   1 ± 3\n";
  EXPECT_EQ(WrappedText("many words above\n" + table + "many words below\n", 12),
            "many words\n  above\n" + table + "many words\n  below\n");
}

TEST(WrappedText, CountCharactersAndNotBytes) {
  EXPECT_EQ(WrappedText("4 ± 1 ± 2", 9), "4 ± 1 ± 2");
  EXPECT_EQ(WrappedText("4 ± 1 ± 23", 9), "4 ± 1 ±\n  23");
}

const std::string kLine = "note: " + std::string(60, 'a') + " " + std::string(60, 'b') + "\n";

// What a terminal shows that nobody writes to any more.
std::string AllOf(int master) {
  std::string all;
  std::array<char, 512> buffer = {};
  for (ssize_t size = 0; (size = read(master, buffer.data(), buffer.size())) > 0;) {
    all.append(buffer.data(), static_cast<std::size_t>(size));
  }
  return all;
}

// A terminal makes \r\n of each \n.
TEST(PrintText, BreaksLinesOnATerminal) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master), 0);
  ASSERT_EQ(unlockpt(master), 0);
  std::FILE* const terminal = std::fopen(ptsname(master), "w");
  ASSERT_NE(terminal, nullptr);
  PrintText(terminal, kLine);
  std::fclose(terminal);
  EXPECT_EQ(AllOf(master),
            "note: " + std::string(60, 'a') + "\r\n  " + std::string(60, 'b') + "\r\n");
  close(master);
}

TEST(PrintText, LeavesLinesWholeInAFile) {
  std::FILE* const file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  PrintText(file, kLine);
  std::rewind(file);
  std::array<char, 512> buffer = {};
  const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), file);
  EXPECT_EQ(std::string(buffer.data(), size), kLine);
  std::fclose(file);
}

}  // namespace
}  // namespace fathom
