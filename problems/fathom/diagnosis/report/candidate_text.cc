// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/candidate_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {

std::string WhyText(const Candidate& candidate) {
  const double gain = candidate.gain;
  switch (candidate.outcome) {
    case CandidateOutcome::kKept:
      return fmt::format(
          "kept: gain {:.0f}; noise alone reaches {:.1f}", gain, candidate.noise_reach);
    case CandidateOutcome::kKeptBesideOthers:
      return "kept: improves the model beside the others";
    case CandidateOutcome::kAlternative:
      return "these logs cannot tell it from a kept cause";
    case CandidateOutcome::kFitFailed:
      return "dropped: its fit gives no usable model";
    case CandidateOutcome::kScoreWithinNoise:
      return fmt::format("dropped: score {:.1f}; noise alone reaches {:.1f}",
                         candidate.score,
                         candidate.noise_reach);
    case CandidateOutcome::kOthersScoreHigher:
      return fmt::format("not refitted: score {:.1f}; others score higher", candidate.score);
    case CandidateOutcome::kGainWithinNoise:
      return fmt::format("dropped: gain {:.1f}; noise alone reaches {:.1f}",
                         std::max(0.0, gain),
                         candidate.noise_reach);
    case CandidateOutcome::kNeedless:
      return fmt::format(
          "dropped: helps alone (gain {:.0f}), adds nothing once the kept causes are in", gain);
    case CandidateOutcome::kRefused:
      return fmt::format("refused: gain {:.0f}, but free runs do not improve by it", gain);
    case CandidateOutcome::kNoBetterThanRefused:
      return fmt::format("dropped: gain {:.0f}, no better than what was refused", gain);
    case CandidateOutcome::kTakenUpByNoise:
      return fmt::format("dropped: gain {:.0f}, but the noise learned without it takes it up",
                         gain);
  }
  return "";
}

std::string NonePassesText(const Diagnosis& diagnosis) {
  if (diagnosis.candidates.empty() || !diagnosis.causes.empty()) return "";
  const Candidate& best = diagnosis.candidates.front();
  return fmt::format(
      "No candidate passes, of {} tried. The best is {} ({}). The gain is twice the "
      "log-likelihood that the effect adds.",
      diagnosis.candidates.size(),
      best.label,
      WhyText(best));
}

}  // namespace fathom
