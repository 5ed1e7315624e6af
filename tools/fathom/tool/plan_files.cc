// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/plan_files.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"

#include <system_error>

#include <fmt/format.h>

namespace fathom {

void RequirePlanFolder(const std::string& out) {
  const std::filesystem::path folder = out;
  const auto holds = [&](const char* name) { return std::filesystem::exists(folder / name); };
  if (holds("plan.json") && !holds("log.yaml")) return;
  for (const char* name : kPlanFiles) {
    if (!holds(name)) continue;
    throw InputError(fmt::format(
        "--out={}: holds {}, which is of no plan, expected another folder.", out, name));
  }
}

void WritePlanFiles(const std::filesystem::path& folder,
                    const std::map<std::string, std::string>& files) {
  for (const char* name : kPlanFiles) {
    if (files.contains(name)) continue;
    std::error_code error;
    std::filesystem::remove(folder / name, error);
    if (!error) continue;
    throw InputError(fmt::format("{}: is of a former plan and cannot be removed: {}.",
                                 (folder / name).string(),
                                 error.message()));
  }
  for (const auto& [name, content] : files) WriteFile(folder / name, content);
}

}  // namespace fathom
