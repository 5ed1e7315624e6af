// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/ordinary_plan.h"

#include "fathom/base/exit_code.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/identification/log_identification.h"
#include "fathom/ordinary_dives/judge_dives.h"
#include "fathom/ordinary_dives/ordinary_file.h"
#include "fathom/ordinary_dives/ordinary_page.h"
#include "fathom/ordinary_dives/ordinary_text.h"
#include "fathom/signal/joined_signals.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/wide_flag.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMostPrinted = 10;  // stretches

FittedModel ModelOfFile(const std::string& file, const JoinedSignals& joined) {
  const std::string text = ReadFile(file);
  if (IsCoupledModel(text)) {
    throw InputError(fmt::format("{}: is a model of several DOFs, expected one of one DOF.", file));
  }
  FittedModel model = ParseModel(file, text);
  if (model.dof != joined.all.dof) {
    throw InputError(fmt::format(
        "--dof: is {}, expected {} as in {}.", Name(joined.all.dof), Name(model.dof), file));
  }
  if (model.force_unit != joined.all.force_unit) {
    throw InputError(fmt::format("--log: commands are in {}, expected {} as in {}.",
                                 joined.all.force_unit,
                                 model.force_unit,
                                 file));
  }
  return model;
}

// What the logs say themselves. Without a usable fit, why is on stderr and nothing is given back.
std::optional<FittedModel> ModelOfLogs(const std::vector<Log>& logs, Dof dof) {
  LogIdentificationOptions options;
  options.dof = dof;
  LogIdentification identified = IdentifyFromLogs(logs, options);
  PrintWarnings(identified.findings);
  if (identified.result.is_usable) {
    for (const std::string& caveat : identified.result.fitted.caveats) {
      PrintText(stderr, "note: " + caveat + "\n");
    }
    return std::move(identified.result.fitted);
  }
  PrintText(stderr,
            fmt::format("fathom_plan: the logs together give no usable model: {} With --model they "
                        "are judged by another one.\n",
                        identified.result.message));
  return std::nullopt;
}

// Of the motion.
TimeInterval SpanOf(const Log& log) {
  TimeInterval span = {INFINITY, -INFINITY};
  for (const std::optional<Stream>* stream : {&log.velocity, &log.pose, &log.detections}) {
    if (!*stream || (*stream)->time.empty()) continue;
    span.from = std::min(span.from, (*stream)->time.front());
    span.to = std::max(span.to, (*stream)->time.back());
  }
  return span;
}

void PrintDives(const OrdinaryRequest& request, const OrdinaryDives& dives) {
  PrintText(stdout, OrdinarySentence(request, dives) + "\n\n");
  PrintText(stdout, TableForTerminal(ChosenStretchTable(request, dives)));
  if (dives.stretches.size() > 1) {
    PrintText(stdout,
              "\n" + TableForTerminal(LoneStretchTable(request, dives, kMostPrinted)) + "\n");
  }
  for (const std::string& line : OrdinaryRemedySentences(dives)) {
    PrintText(stdout, "next: " + line + "\n");
  }
  for (const std::string& command : HowToFitChosen(request, dives)) {
    PrintText(stdout, "next, to fit the chosen stretches alone: " + command + "\n");
  }
  for (const std::string& line : OrdinaryComments(request, dives)) {
    PrintText(stdout, "note: " + line + "\n");
  }
}

}  // namespace

int RunOrdinaryPlan(const OrdinaryPlanFiles& files) {
  RequireFlag("log", FLAGS_log, "the logs of ordinary dives");
  RequireOnePath("model", files.model);
  std::vector<std::string> inputs = InputsFromFlags();
  inputs.push_back(files.model);
  RequireOutputs({{"json", files.json}, {"report", files.report}}, inputs);
  const std::vector<Log> logs = ReadLogsFromFlags(DofFromFlag());
  JoinedSignals joined = JoinSignals(logs, DofFromFlag(), std::nullopt);
  if (IsAllHeldOut(joined.all)) {
    throw InputError(fmt::format("--log: {}", kAllIsHeldOut));
  }
  OrdinaryRequest request;
  request.logs = LogPathsFromFlags();
  request.data_flags = GivenFlags({"velocity", "correct", "default_vehicle"});
  request.name = files.model.empty() ? "the fit of these logs" : files.model;
  if (files.model.empty()) {
    std::optional<FittedModel> model = ModelOfLogs(logs, joined.all.dof);
    if (!model) return kExitNoFit;
    request.model = *std::move(model);
  } else {
    request.model = ModelOfFile(files.model, joined);
  }
  for (const Log& log : logs) request.spans.push_back(SpanOf(log));
  request.segments = std::move(joined.all.train);
  request.log_of_segment = std::move(joined.log_of_train);
  const OrdinaryDives dives = JudgeDives(request);
  if (!dives.IsUsable()) {
    PrintText(stderr, fmt::format("fathom_plan: {}\n", dives.message));
    return kExitNoFit;
  }
  PrintDives(request, dives);
  if (!files.json.empty()) WriteFile(files.json, FormatOrdinaryDives(request, dives));
  if (!files.report.empty()) {
    Page page = OrdinaryPage(request, dives);
    page.origin = OriginOfPage(logs);
    WriteFile(files.report, RenderPage(page));
  }
  return kExitUsable;
}

}  // namespace fathom
