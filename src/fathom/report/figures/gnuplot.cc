// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/figures/gnuplot.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/process/run_child.h"

#include <system_error>

#include <fmt/format.h>
#include <glog/logging.h>
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
  WriteFile(script_file,
            fmt::format("set encoding utf8\n{}\nset output {}\n{}",
                        terminal,
                        GnuplotText(picture.string()),
                        script));
  const ChildResult run = RunChild({.program = "gnuplot", .arguments = {script_file.string()}});
  if (run.end == ChildEnd::kNotStarted) {
    throw InputError(
        fmt::format("{}: cannot draw this figure: gnuplot does not start ({}). Install the package "
                    "gnuplot-nox.",
                    path.string(),
                    run.err));
  }
  if (run.exit_code != 0 || !fs::exists(picture) || fs::file_size(picture) == 0) {
    throw InputError(fmt::format(
        "{}: cannot draw this figure: gnuplot fails: {}", path.string(), run.out + run.err));
  }
  WriteFile(path, ReadFile(picture));
}

}  // namespace fathom
