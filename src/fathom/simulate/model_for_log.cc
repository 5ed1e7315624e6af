// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/model_for_log.h"

#include "fathom/log/log_fingerprint.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace fathom {

ModelForLog RestrictToLog(FittedModel model, const Log& log, bool keep_run_effects) {
  const auto& known = model.log_fingerprints;
  const auto own = std::find(known.begin(), known.end(), FingerprintOf(log)) - known.begin();
  const bool is_known = own < std::ssize(known);
  const std::string name = is_known && own < std::ssize(model.logs) ? model.logs[own] : "";
  ModelForLog restricted;
  restricted.is_trained_on_it = is_known;
  std::erase_if(model.effects, [&](const ActiveEffect& active) {
    const EffectInfo& info = active.effect->info();
    if (info.scope != Scope::kRun || keep_run_effects) return false;
    if (is_known && active.setting.ActsIn(name)) return false;
    restricted.left_out.push_back(LabelOf(info, active.setting));
    return true;
  });
  for (ActiveEffect& active : model.effects) active.setting.log.clear();  // this is the log
  restricted.model = std::move(model);
  return restricted;
}

}  // namespace fathom
