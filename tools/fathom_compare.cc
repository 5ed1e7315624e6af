// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Every identifier family on every source of a log, in one table: the paper's Table II and Fig. 5.
// Or every structure of a coupled model of several DOFs.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/quoted.h"
#include "fathom/comparison/comparison.h"
#include "fathom/comparison/comparison_file.h"
#include "fathom/comparison/comparison_page.h"
#include "fathom/comparison/comparison_panels.h"
#include "fathom/comparison/structure_comparison.h"
#include "fathom/comparison/structure_file.h"
#include "fathom/comparison/structure_page.h"
#include "fathom/comparison/structure_text.h"
#include "fathom/findings/log_check.h"
#include "fathom/free_decay/log_decay.h"
#include "fathom/report/figures/figure.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/tool/identifier_flags.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tell_free_decay.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/wide_flag.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(dofs, "", "Comma-separated. Default: the DOFs that log.yaml names, of every log.");
DEFINE_string(
    families,
    "",
    "Comma-separated: least_squares, adaptive, output_error, joint. Default: all that the log "
    "allows.");
DEFINE_string(sources,
              "",
              "Comma-separated: pose_estimator (velocity.csv), camera (poses). Default: all that "
              "every log has.");
DEFINE_string(structures,
              "",
              "Instead of families, structures of one coupled model of --dofs: all, or "
              "comma-separated of diagonal, coriolis, lift, symmetric, full, lopsided, auto "
              "(chosen as the data show). Models of one DOF each stand beside them.");
DEFINE_double(window, 20.0, "Of --structures: the simulation begins anew after so long [s].");
DEFINE_string(json, "", "Write the rows to this JSON file.");
DEFINE_string(report, "", "Write a page to this HTML file.");
DEFINE_string(figures,
              "",
              "Write <dof>_response.svg and <dof>_parameters.svg (and .png) into this folder.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_compare",
    "Compares identifier families and sources on one log, or on several together, or structures "
    "of a coupled model, scored by simulating from the command alone.",
    "--log=LOG [--log=LOG ...] [--dofs=surge,...] [--families=...] [--sources=...] [--json=FILE] "
    "[--report=FILE]\n"
    "--log=LOG [--log=LOG ...] [--dofs=surge,...] --structures=all|NAME,... [--window=SECONDS] "
    "[--families=...] [--json=FILE] [--report=FILE]",
    "fathom_compare --log=data/flatfish --dofs=surge,heave,yaw --report=flatfish.html",
    "The row to take is marked *: of those whose held-out velocity NMAE is the least within "
    "chance, the one whose parameters are determined best (docs/comparison.md). A row without a "
    "usable model is marked !. The family joint needs "
    "detections.csv, camera.yaml, tags.yaml and mount.yaml. With --structures the row marked * is "
    "what auto chose. Exit code 2: a DOF, or the row to be marked, has no usable model.",
    {"log"}};

// What a flag lists, each once.
template <typename T>
std::vector<T> ListFromFlag(const char* flag,
                            const std::string& value,
                            T (*parse)(const std::string&)) {
  std::vector<T> list;
  for (const std::string& name : SplitAtCommas(value)) {
    const T one = ParseFlag(flag, name, parse);
    if (std::ranges::find(list, one) != list.end()) {
      throw InputError(fmt::format("--{}: names {} twice, expected each once.", flag, name));
    }
    list.push_back(one);
  }
  return list;
}

ComparisonOptions OptionsFromFlags() {
  ComparisonOptions options;
  options.dofs = ListFromFlag("dofs", FLAGS_dofs, ParseDof);
  options.families = ListFromFlag("families", FLAGS_families, ParseFamily);
  options.sources = ListFromFlag("sources", FLAGS_sources, ParseSource);
  options.identification = IdentificationOptionsFromFlags();
  return options;
}

void Print(const DofComparison& dof) {
  std::printf("%s", TableForTerminal(ParameterTable(dof)).c_str());
  for (const std::string& line : CommentsOn(dof)) PrintText(stdout, line + "\n");
  std::printf("\n");
}

void WriteFigures(const DofComparison& dof, const std::string& folder) {
  for (const char* extension : {"svg", "png"}) {
    WriteFigure(ResponsePanel(dof),
                fmt::format("{}/{}_response.{}", folder, Name(dof.dof), extension));
    WriteFigure(ParameterPanels(dof),
                fmt::format("{}/{}_parameters.{}", folder, Name(dof.dof), extension));
  }
}

// Makes the source `camera` of logs with detections where it is asked for, or where all sources
// are; in the latter case a calibration that is missing or unusable only costs that source.
void AddCameraSourceIfWanted(const ComparisonOptions& options, std::vector<Log>* logs) {
  const auto& sources = options.sources;
  const bool is_asked_for = std::ranges::find(sources, Source::kCamera) != sources.end();
  for (Log& log : *logs) {
    if (is_asked_for) AddCameraSource(&log);
    if (sources.empty()) AddCameraSourceIfUsable(&log);
  }
}

// The one DOF that --dofs names, if it is one. Throws InputError if a log is a CSV file and there
// is none.
std::optional<Dof> OnlyDof(const std::vector<Dof>& dofs) {
  if (dofs.size() == 1) return dofs.front();
  for (const std::string& path : LogPathsFromFlags()) {
    if (!std::filesystem::is_regular_file(path)) continue;
    throw InputError(path +
                     ": a single CSV (t,tau,v) does not say whose force and speed it holds, "
                     "expected one DOF with it, for example --dofs=surge.");
  }
  return std::nullopt;
}

// The DOF of logs without a command, which only their decay tells of; nothing of others. Throws
// InputError where it is one of several.
std::optional<Dof> DofOfDecay(const std::vector<Log>& logs, const std::vector<Dof>& dofs) {
  const bool has_command =
      std::ranges::any_of(logs, [](const Log& log) { return log.command.has_value(); });
  if (has_command) return std::nullopt;
  const Dof dof = DofOfAll(logs, dofs.size() == 1 ? std::optional(dofs.front()) : std::nullopt);
  return AreFreeDecays(logs, dof) ? std::optional(dof) : std::nullopt;
}

bool IsGiven(const char* flag) { return !gflags::GetCommandLineFlagInfoOrDie(flag).is_default; }

// Nothing stands for auto.
std::optional<StandardStructure> ParseStructure(const std::string& name) {
  if (name == "auto") return std::nullopt;
  if (const auto structure = StandardStructureFromName(name)) return structure;
  throw InputError(
      fmt::format("is {}, expected all, or of diagonal, coriolis, lift, symmetric, full, lopsided "
                  "and auto.",
                  Quoted(name)));
}

StructureComparisonOptions StructureOptionsFromFlags() {
  for (const char* flag : {"sources", "figures"}) {
    if (!IsGiven(flag)) continue;
    throw InputError(
        fmt::format("--{}: goes with families, expected none beside --structures.", flag));
  }
  StructureComparisonOptions options;
  options.dofs = ListFromFlag("dofs", FLAGS_dofs, ParseDof);
  std::ranges::sort(options.dofs);
  if (FLAGS_structures != "all") {
    options.structures.emplace();
    options.has_auto = false;
    for (const auto& structure : ListFromFlag("structures", FLAGS_structures, ParseStructure)) {
      if (structure) {
        options.structures->push_back(*structure);
      } else {
        options.has_auto = true;
      }
    }
  }
  if (!FLAGS_families.empty()) {
    options.families = ListFromFlag("families", FLAGS_families, ParseSignalFamily);
  }
  options.identification = IdentificationOptionsFromFlags();
  options.fit.window = FLAGS_window;
  if (const auto problems = options.fit.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--{}.", problems.front()));
  }
  return options;
}

int RunStructures() {
  StructureComparisonOptions options = StructureOptionsFromFlags();
  RequireOutputs({{"json", FLAGS_json}, {"report", FLAGS_report}}, InputsFromFlags());
  const std::vector<Log> logs = ReadLogsFromFlags(OnlyDof(options.dofs), false, true);
  if (options.dofs.empty()) {
    options.dofs = CommonDofs(logs);
    std::ranges::sort(options.dofs);
  }
  // Before the fits, which take a while.
  const std::vector<Finding> findings = CheckLogs(logs, options.dofs);
  PrintWarnings(findings);
  PrintNotes(findings);
  std::fflush(stdout);
  const StructureComparison comparison = CompareStructures(logs, options);
  PrintText(stdout, StructureSentence(comparison) + "\n\n");
  std::printf("%s\n", TableForTerminal(UnseenTable(comparison)).c_str());
  std::printf("%s", TableForTerminal(FittedTable(comparison)).c_str());
  for (const std::string& line : CommentsOn(comparison)) PrintText(stdout, line + "\n");
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatStructures(comparison));
  if (!FLAGS_report.empty()) {
    Page page = StructurePage(comparison);
    for (const Finding& finding : findings) {
      const bool is_warning = finding.severity != Severity::kNote;
      (is_warning ? page.warnings : page.sections.front().notes).push_back(finding.sentence);
    }
    page.origin = OriginOfPage(logs);
    WriteFile(FLAGS_report, RenderPage(page));
  }
  return comparison.Taken() != nullptr ? kExitUsable : kExitNoFit;
}

int Run() {
  if (!FLAGS_structures.empty()) {
    RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
    return RunStructures();
  }
  if (IsGiven("window")) {
    throw InputError("--window: goes with --structures, expected none: families have no window.");
  }
  const ComparisonOptions options = OptionsFromFlags();
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  RequireOutputs({{"json", FLAGS_json}, {"report", FLAGS_report}}, InputsFromFlags());
  std::vector<Log> logs = ReadLogsFromFlags(OnlyDof(options.dofs), false, true);
  if (const auto dof = DofOfDecay(logs, options.dofs)) {
    return TellFreeDecay(logs,
                         FitLogDecay(logs, {.dof = *dof}),
                         {.lacks = "nothing to compare",
                          .logs = FLAGS_log,
                          .json = FLAGS_json,
                          .page = FLAGS_report,
                          .origin = OriginOfPage(logs)});
  }
  AddCameraSourceIfWanted(options, &logs);
  const Comparison comparison = Compare(logs, options);
  for (const DofComparison& part : comparison.dofs) PrintWarnings(part.findings);
  for (const DofComparison& part : comparison.dofs) Print(part);
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatComparison(comparison));
  if (!FLAGS_report.empty()) {
    Page page = ComparisonPage(comparison);
    page.origin = OriginOfPage(logs);
    WriteFile(FLAGS_report, RenderPage(page));
  }
  if (!FLAGS_figures.empty()) {
    for (const DofComparison& part : comparison.dofs) WriteFigures(part, FLAGS_figures);
  }
  const bool all_usable = std::ranges::all_of(comparison.dofs, [](const DofComparison& part) {
    return std::ranges::any_of(part.rows, [](const Identification& row) { return row.is_usable; });
  });
  return all_usable ? 0 : 2;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
