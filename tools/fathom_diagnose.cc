// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a simulation gets wrong, and why: names the cause as far as the logs force it.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/parallel_for.h"
#include "fathom/coupled/cause_words.h"
#include "fathom/coupled/coupled_page.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/coupled/coupled_verdict_file.h"
#include "fathom/coupled_planning/coupled_plan_hint.h"
#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/report/candidate_text.h"
#include "fathom/diagnosis/report/diagnosis_page.h"
#include "fathom/diagnosis/report/diagnosis_tables.h"
#include "fathom/diagnosis/report/legend.h"
#include "fathom/diagnosis/report/limit_text.h"
#include "fathom/diagnosis/report/next_steps.h"
#include "fathom/diagnosis/report/verdict_file.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/findings/log_check.h"
#include "fathom/free_decay/log_decay.h"
#include "fathom/joint_refinement/logs/face_on_poses.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/log/remark.h"
#include "fathom/planning/plan_hint.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/tool/coupled_flags.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/progress.h"
#include "fathom/tool/tell_free_decay.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/wide_flag.h"
#include "fathom/vehicle/files/thruster_shares.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(source,
              "",
              "pose_estimator (velocity.csv only) or camera (poses only). Default: all that the "
              "logs have; effects on a sensor need both.");
DEFINE_string(verdict, "", "Write the verdict, with the extended model in it, to this JSON file.");
DEFINE_string(report, "", "Write a page to this HTML file.");
DEFINE_double(
    false_alarm_rate,
    0.05,
    "Nominal probability of naming a cause when nothing is missing, above 0 and at most 0.5. "
    "Of 5 % less than 3 are measured: docs/diagnosis_scores.md.");
DEFINE_double(effort,
              1.0,
              "How long causes are searched where no model fits, as a multiple of the usual.");
DEFINE_int32(threads, 0, "Fits that run at once; 0: one on each core. Not a digit depends on it.");
DEFINE_uint64(seed, 1, "Seed of the random draws behind the thresholds.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_diagnose",
    "Finds what the model of one degree of freedom gets wrong, names the cause when the data "
    "allow only one answer, and measures how much the model improves with it. With --dofs it finds "
    "couplings between degrees of freedom, and thrusters that are weak.",
    "--log=LOG [--log=LOG ...] --dof=DOF [--source=SOURCE] [--verdict=FILE] [--report=FILE]\n"
    "--log=LOG [--log=LOG ...] --dofs=DOF,DOF... [--window=SECONDS] [--verdict=FILE] "
    "[--report=FILE]",
    "fathom_diagnose --log=data/flatfish --dof=surge --verdict=surge.json --report=surge.html\n"
    "  fathom_simulate --model=surge.json --log=data/flatfish",
    "Several logs, as --log=A --log=B or --log=A,B, are diagnosed together. Every verdict is a "
    "usable result, also `consistent` and `unexplained`. Kept candidates are marked *. Of a log "
    "that "
    "nothing drives it tells the ratios of the free decay.",
    {"log"}};

constexpr std::size_t kMostCandidates = 8;

void SetThreadsFromFlag() {
  if (FLAGS_threads < 0) {
    throw InputError(fmt::format("--threads: is {}, expected at least 0.", FLAGS_threads));
  }
  if (FLAGS_threads > 0) SetNumThreads(FLAGS_threads);
}

DiagnosisOptions OptionsFromFlags() {
  DiagnosisOptions options;
  if (!(FLAGS_false_alarm_rate > 0.0 && FLAGS_false_alarm_rate <= 0.5)) {
    throw InputError(fmt::format("--false_alarm_rate: is {}, expected above 0 and at most 0.5.",
                                 FLAGS_false_alarm_rate));
  }
  options.false_alarm_rate = FLAGS_false_alarm_rate;
  options.seed = FLAGS_seed;
  if (!(FLAGS_effort > 0.0)) {
    throw InputError(fmt::format("--effort: is {}, expected above 0.", FLAGS_effort));
  }
  options.effort = FLAGS_effort;
  return options;
}

// The log with the motion streams of --source.
Log WithSourceFromFlag(Log log) {
  if (FLAGS_source.empty()) {
    AddCameraSourceIfUsable(&log);
    return log;
  }
  const Source source = ParseFlag("source", FLAGS_source, ParseSource);
  if (source == Source::kCamera) AddCameraSource(&log);
  log = WithSourceOnly(std::move(log), source);
  if (!(source == Source::kCamera ? log.pose : log.velocity)) {
    throw InputError(fmt::format("--source={}: {} has no such source.", FLAGS_source, log.name));
  }
  return log;
}

// As the vehicle file in the log says; opening the log told what is wrong with that.
std::vector<Thruster> ThrustersOf(const Log& log) {
  const std::optional<Vehicle> vehicle = VehicleOf(log);
  return vehicle ? vehicle->thrusters : std::vector<Thruster>();
}

struct Logs {
  Dof dof = Dof::kSurge;  // to be diagnosed
  std::vector<Log> all;
  std::vector<std::string> fingerprints;  // of the logs as they lie there, whatever --source
  PageOrigin origin;                      // so are they here
};

Logs LogsFromFlags() {
  const std::optional<Dof> dof = DofFromFlag();
  Logs logs;
  logs.all = ReadLogsFromFlags(dof, false, true);
  RequireDofOrDofs(logs.all, dof);
  logs.dof = DofOfAll(logs.all, dof);
  logs.origin = OriginOfPage(logs.all);
  logs.fingerprints = FingerprintsOf(logs.all);
  for (Log& log : logs.all) log = WithSourceFromFlag(std::move(log));
  Progress progress("round of refining the poses");
  for (Log& log : logs.all) {
    RefineFaceOnPoses(logs.dof, &log, [&](int round, int most) { progress.Show(round, most); });
  }
  return logs;
}

// A sentence where nothing is missing: the table then only tells noise from noise.
void PrintCandidates(const Diagnosis& diagnosis, const std::function<void(const Table&)>& print) {
  if (diagnosis.candidates.empty()) return;
  if (diagnosis.verdict != Verdict::kConsistent) {
    print(CandidateTable(diagnosis, kMostCandidates));
    return;
  }
  PrintText(stdout,
            fmt::format("\n{} --verdict and --report list them all.\n", NonePassesText(diagnosis)));
}

// `plan_command`: plans the deciding experiment; may be empty.
void Print(const Diagnosis& diagnosis, const std::string& plan_command) {
  PrintText(stdout,
            fmt::format("{}: {}\n{}\n",
                        Name(diagnosis.dof),
                        Name(diagnosis.verdict),
                        VerdictSentence(diagnosis)));
  std::vector<Table> shown;
  const auto print = [&](const Table& table) {
    shown.push_back(ShownInTerminal(table));
    std::printf("\n%s", TableForTerminal(table).c_str());
  };
  if (!diagnosis.causes.empty()) print(CauseTable(diagnosis));
  print(BeforeAndAfterTable(diagnosis));
  std::printf("%s", NoiseFloorText(diagnosis).c_str());
  PrintCandidates(diagnosis, print);
  std::printf("%s", LegendOf(shown).c_str());
  if (diagnosis.causes.empty() && !diagnosis.limits.empty()) {
    PrintText(stdout, fmt::format("\n{}\n", HowToReadLimits(diagnosis)));
    std::printf("%s", TableForTerminal(LimitTable(diagnosis)).c_str());
  }
  std::printf("\n");
  for (const std::string& step : NextSteps(diagnosis)) PrintText(stdout, "next: " + step + "\n");
  if (!plan_command.empty()) {
    PrintText(stdout, fmt::format("next, to plan the deciding run: {}\n", plan_command));
  }
  for (const std::string& remark : diagnosis.remarks) PrintText(stdout, "note: " + remark + "\n");
}

void WritePage(Page page, const Logs& logs) {
  page.origin = logs.origin;
  WriteFile(FLAGS_report, RenderPage(page));
}

// Those that are not among others.
std::vector<Finding> Without(std::vector<Finding> findings, const std::vector<Finding>& others) {
  std::erase_if(findings, [&](const Finding& finding) {
    return std::ranges::any_of(
        others, [&](const Finding& other) { return other.sentence == finding.sentence; });
  });
  return findings;
}

void PrintCoupled(const CoupledDiagnosis& diagnosis,
                  const CoupledIdentification& identified,
                  const std::string& plan_command) {
  PrintText(
      stdout,
      fmt::format(
          "{}: {}\n", Name(diagnosis.verdict), CoupledVerdictSentence(diagnosis, identified)));
  if (diagnosis.causes.size() > 1) {
    for (const NamedEntry& cause : diagnosis.causes) {
      PrintText(stdout, CauseSentence(cause, identified.fitted.force_unit) + "\n");
    }
  }
  PrintText(stdout, "\n" + FormatCoupledIdentification(identified) + "\n");
  for (const std::string& step : CoupledNextSteps(diagnosis, plan_command)) {
    PrintText(stdout, "next: " + step + "\n");
  }
  for (const std::string& remark : identified.remarks) PrintText(stdout, "note: " + remark + "\n");
}

int RunCoupledDiagnosis() {
  const CoupledIdentificationOptions options = CoupledOptionsFromFlags();
  RequireOutputs({{"verdict", FLAGS_verdict}, {"report", FLAGS_report}}, InputsFromFlags());
  std::vector<Log> logs = ReadCoupledLogsFromFlags();
  const PageOrigin origin = OriginOfPage(logs);
  std::vector<Finding> findings = CheckLogs(logs, options.dofs);
  PrintWarnings(findings);
  std::fflush(stderr);
  const CoupledIdentification identified = IdentifyCoupled(std::move(logs), options);
  if (!identified.is_usable) {
    std::fprintf(stderr, "fathom_diagnose: no diagnosis: %s.\n", identified.message.c_str());
    return kExitNoFit;
  }
  const CoupledDiagnosis diagnosis = DiagnoseCoupled(identified, std::move(findings));
  std::string plan_command;
  if (!FLAGS_verdict.empty()) {
    const std::string verdict = FormatCoupledVerdict(diagnosis, identified);
    WriteFile(FLAGS_verdict, verdict);
    plan_command = CoupledPlanCommandOfVerdict(verdict, FLAGS_verdict);
  }
  if (!FLAGS_report.empty()) {
    Page page = CoupledPage(diagnosis, identified, plan_command);
    page.origin = origin;
    WriteFile(FLAGS_report, RenderPage(page));
  }
  PrintCoupled(diagnosis, identified, plan_command);
  return kExitUsable;
}

int Run() {
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  RequireFlagsOfOneKind({"dof", "source", "false_alarm_rate", "effort", "seed"});
  SetThreadsFromFlag();
  if (IsCoupledAsked()) return RunCoupledDiagnosis();
  DiagnosisOptions options = OptionsFromFlags();
  RequireOutputs({{"verdict", FLAGS_verdict}, {"report", FLAGS_report}}, InputsFromFlags());
  const Logs logs = LogsFromFlags();
  if (AreFreeDecays(logs.all, logs.dof)) {
    const LogDecay decay = FitLogDecay(logs.all, {.dof = logs.dof});
    // A command of 0 over a vehicle at rest is a fault of the log.
    const bool lacks_command =
        std::ranges::any_of(logs.all, [](const Log& log) { return !log.command; });
    if (decay.summary.IsUsable() || lacks_command) {
      return TellFreeDecay(logs.all,
                           decay,
                           {.lacks = "no diagnosis",
                            .logs = FLAGS_log,
                            .json = FLAGS_verdict,
                            .page = FLAGS_report,
                            .origin = logs.origin});
    }
  }
  options.thrusters = ThrustersOf(logs.all.front());
  // A search may take a minute, and a red finding may make it idle.
  std::vector<Finding> told;
  options.on_findings = [&](const std::vector<Finding>& findings) {
    PrintWarnings(findings);
    told = findings;
  };
  Diagnosis diagnosis = Diagnose(logs.all, logs.dof, options);
  PrintWarnings(Without(diagnosis.findings, told));
  if (const std::string why = WhyOfNoUse(diagnosis); !why.empty()) {
    std::fprintf(stderr, "fathom_diagnose: no diagnosis: %s\n", why.c_str());
    if (!FLAGS_report.empty()) {
      WritePage(NoDiagnosisPage(diagnosis, why), logs);
    }
    return 2;
  }
  for (const Log& log : logs.all) {
    for (const Remark& remark : log.remarks) {
      if (remark.kind == RemarkKind::kGeneral || remark.kind == RemarkKind::kSurfaces) continue;
      diagnosis.remarks.push_back(remark.text);
    }
  }
  std::string plan_command;
  if (!FLAGS_verdict.empty()) {
    const std::string verdict = FormatVerdict(diagnosis, logs.fingerprints);
    WriteFile(FLAGS_verdict, verdict);
    plan_command = PlanCommandOfVerdict(verdict, FLAGS_verdict);
  }
  if (!FLAGS_report.empty()) WritePage(DiagnosisPage(diagnosis, plan_command), logs);
  Print(diagnosis, plan_command);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
