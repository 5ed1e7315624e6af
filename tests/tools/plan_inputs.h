// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run_tool.h"

namespace fathom {

// In an empty folder: the small model, a tank, and what is to be written.
struct PlanInputs {
  PlanInputs();

  std::filesystem::path folder = EmptyTestFolder();
  std::string model, tank, vehicle;

  std::string At(const std::string& name) const { return (folder / name).string(); }

  // Of 42 s in the tank, into plan/; and what is said where it is refused.
  ToolRun Plan(const std::vector<std::string>& more = {}) const;
  std::string Refusal(const std::vector<std::string>& more = {}) const;
};

// The vehicle of the small model, with the thrusters of a BlueROV2.
struct ThrusterInputs : PlanInputs {
  const std::string heavy = "--vehicle=" FATHOM_DATA_DIR "/vehicles/bluerov2_heavy.yaml";

  ToolRun PlanThrusters() const { return RunsWell(Plan({heavy, "--voltage=16"})); }

  // Of a file in plan/.
  std::vector<double> Column(const std::string& file, const std::string& name) const;
};

// The arguments of the command that a tool printed behind `beginning`, to the end of the line; none
// if it did not.
std::vector<std::string> HintedArguments(const std::string& out, const std::string& beginning);

}  // namespace fathom
