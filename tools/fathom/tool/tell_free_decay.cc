// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/tell_free_decay.h"

#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/free_decay/decay_page.h"
#include "fathom/free_decay/decay_text.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/vehicle/effects/in_words.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

namespace fathom {
namespace {

Page PageOf(const LogDecay& decay,
            const std::vector<Finding>& findings,
            const FreeDecayOutputs& outputs) {
  Page page;
  page.title = fmt::format("{}: free decay of {}", outputs.logs, Name(decay.dof));
  page.lead = {InWords(DecaySentence(decay))};
  for (const Finding& finding : findings) {
    if (finding.severity == Severity::kWarning) page.warnings.push_back(finding.sentence);
  }
  page.sections = {DecaySection(decay)};
  page.origin = outputs.origin;
  return page;
}

}  // namespace

int TellFreeDecay(std::span<const Log> logs,
                  const LogDecay& decay,
                  const FreeDecayOutputs& outputs) {
  const std::vector<Finding> findings = FindingsOn(logs, decay);
  PrintWarnings(findings);
  PrintNotes(findings);
  const bool is_usable = decay.summary.IsUsable();
  if (is_usable && !outputs.json.empty()) {
    WriteFile(outputs.json, FormatDecayJson(decay, outputs.logs));
  }
  if (!outputs.page.empty()) WriteFile(outputs.page, RenderPage(PageOf(decay, findings, outputs)));
  if (!is_usable) {
    PrintText(stderr,
              fmt::format("{}: {}: {}\n",
                          gflags::ProgramInvocationShortName(),
                          outputs.lacks,
                          DecaySentence(decay)));
    return kExitNoFit;
  }
  PrintText(stdout, DecaySentence(decay) + "\n\n" + FormatDecay(decay));
  if (const double nmae = NmaeOf(decay); std::isfinite(nmae)) {
    PrintText(stdout,
              fmt::format("The simulated decay misses {:.2g} % of the speed.\n", 100.0 * nmae));
  }
  return kExitUsable;
}

}  // namespace fathom
