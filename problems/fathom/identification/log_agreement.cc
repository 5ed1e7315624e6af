// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/log_agreement.h"

#include "fathom/identification/run_agreement_text.h"

#include <cmath>
#include <utility>

namespace fathom {

Signals TrainingOf(std::size_t log, const JoinedSignals& joined) {
  Signals own;
  own.dof = joined.all.dof;
  own.source = joined.all.source;
  own.force_unit = joined.all.force_unit;
  for (std::size_t k = 0; k < joined.all.train.size(); ++k) {
    if (joined.log_of_train[k] == log) own.train.push_back(joined.all.train[k]);
  }
  return own;
}

RunAgreement WidenByAgreement(const std::vector<std::string>& names,
                              const JoinedSignals& joined,
                              const IdentificationOptions& options,
                              Identification* together) {
  IdentificationOptions alone_options = options;
  alone_options.output_error.offsets = {};
  std::vector<RunEstimate> runs;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Signals own = TrainingOf(k, joined);
    const Identification alone = Identify(own, own, together->family, alone_options);
    RunEstimate& run = runs.emplace_back();
    run.log = names[k];
    run.is_usable = alone.is_usable;
    if (!run.is_usable) continue;
    run.value = ToVector(alone.fitted.model);
    run.std = alone.fitted.covariance.topLeftCorner<kNumParameters, kNumParameters>()
                  .diagonal()
                  .cwiseSqrt();
  }
  RunAgreement agreement = AgreementOf(std::move(runs));
  if (!together->is_usable) return agreement;
  FittedModel& fitted = together->fitted;
  ParameterVector widening;
  for (int i = 0; i < kNumParameters; ++i) {
    widening[i] = agreement.spreads[i].WideningOf(std::sqrt(fitted.covariance(i, i)));
  }
  fitted.covariance = widening.asDiagonal() * fitted.covariance * widening.asDiagonal();
  for (std::string& remark : RemarksOn(agreement, widening)) {
    fitted.caveats.push_back(std::move(remark));
  }
  return agreement;
}

}  // namespace fathom
