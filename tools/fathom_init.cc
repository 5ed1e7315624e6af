// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The files that a folder lacks to be a log, commented, for a user to fill in.

#include "fathom/base/files/output_file.h"
#include "fathom/starter/starter.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"

#include <filesystem>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(folder, ".", "The folder to look at, and to write into.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    .name = "fathom_init",
    .summary = "Writes the files that a folder lacks to be a log, for you to fill in.",
    .usage = "[FOLDER | --folder=FOLDER]",
    .example =
        "mkdir -p my_dive && cp data/recordings/pool.csv my_dive\n"
        "  fathom_init my_dive",
    .details =
        "Of a log: log.yaml and a vehicle file. Of recordings of other programs: a map for "
        "each, as fathom_import --suggest gives it, and a vehicle file. Nothing is "
        "overwritten.",
    .positional_flag = "folder"};

int Run() {
  const std::filesystem::path folder = RequireFlag("folder", FLAGS_folder, "a folder");
  const Starter starter = StarterOf(folder);
  for (const std::string& name : starter.kept) {
    fmt::print("kept   {}\n", (folder / name).string());
  }
  for (const StarterFile& file : starter.files) {
    WriteFile(folder / file.name, file.text);
    fmt::print("wrote  {}\n", (folder / file.name).string());
  }
  for (const std::string& remark : starter.remarks) PrintText(stdout, "note: " + remark + "\n");
  if (starter.commands.empty()) return 0;
  fmt::print("\n{}, type:\n\n", starter.files.empty() ? "Next" : "Fill in what was written. Then");
  for (const std::string& command : starter.commands) fmt::print("  {}\n", command);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
