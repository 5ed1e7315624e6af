// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/figures/gnuplot.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"

#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <glog/logging.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

// A folder of its own that is gone in the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "fathom_figure_XXXXXX").string();
    PCHECK(mkdtemp(name.data()) != nullptr) << name;
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string Terminal(const fs::path& path, int width, int height) {
  if (path.extension() == ".svg") {
    return fmt::format(
        "set terminal svg noenhanced size {},{} font 'DejaVu Sans,Arial,sans-serif,13' "
        "background rgb 'white'",
        width,
        height);
  }
  if (path.extension() == ".png") {
    return fmt::format(
        "set terminal pngcairo noenhanced size {},{} font 'DejaVu Sans,10' fontscale 2 linewidth 2 "
        "pointscale 2 background rgb 'white'",
        2 * width,
        2 * height);
  }
  throw InputError(fmt::format("{}: this figure ends in '{}', expected .svg or .png.",
                               path.string(),
                               path.extension().string()));
}

// The exit status of gnuplot, what it says going to `log`. Throws InputError if there is no
// gnuplot.
int Run(const fs::path& script, const fs::path& log, const fs::path& figure) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(
      &actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);

  std::string program = "gnuplot";
  std::string argument = script.string();
  char* const arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw InputError(
        fmt::format("{}: cannot draw this figure: gnuplot does not start ({}). Install the package "
                    "gnuplot-nox.",
                    figure.string(),
                    std::strerror(error)));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) PCHECK(errno == EINTR);
  return status;
}

}  // namespace

std::string GnuplotText(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "'";
}

void DrawWithGnuplot(const std::string& script,
                     int width,
                     int height,
                     const std::filesystem::path& path) {
  const std::string terminal = Terminal(path, width, height);
  const ScratchFolder folder;
  const fs::path script_file = folder.path() / "script";
  const fs::path picture = folder.path() / "picture";
  const fs::path log = folder.path() / "log";
  WriteFile(script_file,
            fmt::format("set encoding utf8\n{}\nset output {}\n{}",
                        terminal,
                        GnuplotText(picture.string()),
                        script));
  const int status = Run(script_file, log, path);
  if (status != 0 || !fs::exists(picture) || fs::file_size(picture) == 0) {
    throw InputError(fmt::format(
        "{}: cannot draw this figure: gnuplot fails: {}", path.string(), ReadFile(log)));
  }
  WriteFile(path, ReadFile(picture));
}

}  // namespace fathom
