// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Stands in for any of Fathom's programs, under its name. With a log whose folder is called
// "segfault", "hang", "memory" or "damage" it does that; "segfault_diagnose" does it under that
// name alone, and so on. Else it becomes the program.

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace {

std::string LogOf(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--log=") || word.starts_with("--survey=")) {
      return std::filesystem::path(word.substr(word.find('=') + 1)).filename().string();
    }
  }
  return "";
}

// Address space until no more is given. Then it ends as Fathom's programs do: with exit code 4.
int EatMemory() {
  const std::size_t megabyte = std::size_t{1} << 20;
  while (mmap(nullptr, megabyte, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED) {
  }
  usleep(200'000);
  return 4;
}

// To where its result would go.
int WriteHalfAFile(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--model=")) std::ofstream(word.substr(8)) << "{\"schema\": ";
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  const std::string verb = name.substr(std::string("fathom_").size());
  const std::string log = LogOf(argc, argv);
  const auto is_asked = [&](const std::string& what) {
    return (log == what && verb != "batch") || log == what + "_" + verb;
  };
  if (is_asked("segfault")) raise(SIGSEGV);
  if (is_asked("hang")) pause();
  if (is_asked("memory")) return EatMemory();
  if (is_asked("damage")) return WriteHalfAFile(argc, argv);
  const std::string program = std::string(FATHOM_TOOLS_DIR) + "/" + name;
  execv(program.c_str(), argv);
  return 127;
}
