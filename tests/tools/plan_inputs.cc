// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plan_inputs.h"

#include <sstream>

#include "expect_refusal.h"
#include "saved_files.h"
#include "small_log.h"

namespace fathom {
namespace {

std::vector<std::string> PlanArguments(const PlanInputs& inputs,
                                       const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"--model=" + inputs.model,
                                        "--limits=" + inputs.tank,
                                        "--duration=42",
                                        "--out=" + inputs.At("plan")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

PlanInputs::PlanInputs()
    : model(WriteTestFile(folder / "model.json", SmallModelJson()).string()),
      tank(WriteTestFile(folder / "tank.yaml",
                         "force: 12\nspeed: 0.5\ndistance: {back: 2, ahead: 3}\n"
                         "shortest_hold: 0.7\n")
               .string()),
      vehicle(WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml()).string()) {}

ToolRun PlanInputs::Plan(const std::vector<std::string>& more) const {
  return RunToolBinary("fathom_plan", PlanArguments(*this, more));
}

std::string PlanInputs::Refusal(const std::vector<std::string>& more) const {
  return ExpectRefusal("fathom_plan", PlanArguments(*this, more), folder);
}

std::vector<double> ThrusterInputs::Column(const std::string& file, const std::string& name) const {
  return ReadColumns(At("plan/" + file)).Values(name);
}

std::vector<std::string> HintedArguments(const std::string& out, const std::string& beginning) {
  const std::string start = "\n" + beginning;
  const std::size_t at = out.find(start);
  if (at == std::string::npos) return {};
  const std::size_t from = at + start.size();
  std::istringstream words(out.substr(from, out.find('\n', from) - from));
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word);
  return arguments;
}

}  // namespace fathom
