// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>

namespace fathom {

// What fathom_plan may write into the folder of --out.
inline constexpr std::array kPlanFiles = {
    "command.csv", "experiment.yaml", "plan.json", "thrusters.csv", "pulses.csv", "plan.lua"};

// Throws InputError if a plan in this folder would replace what is none: command.csv of a log.
void RequirePlanFolder(const std::string& out);

// Writes these of them, each name with its content, and removes the others: the pulses of a former
// plan must not lie beside this command. Throws InputError, naming the file, if one cannot be
// written or removed.
void WritePlanFiles(const std::filesystem::path& folder,
                    const std::map<std::string, std::string>& files);

}  // namespace fathom
