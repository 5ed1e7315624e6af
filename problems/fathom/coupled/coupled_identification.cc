// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_identification.h"

#include "fathom/base/input_error.h"
#include "fathom/coupled/coupled_caveats.h"
#include "fathom/coupled/identification_task.h"
#include "fathom/log/log_fingerprint.h"

#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

std::vector<std::string> RemarksOn(const std::vector<CoupledData>& logs) {
  std::vector<std::string> remarks;
  for (const CoupledData& log : logs) {
    for (const std::string& remark : log.remarks) {
      remarks.push_back(logs.size() > 1 ? fmt::format("{}: {}", log.log, remark) : remark);
    }
  }
  return remarks;
}

// The structure, as asked for or by the ladder, and its fit.
void FitTask(const IdentificationTask& task,
             const CoupledIdentificationOptions& options,
             CoupledIdentification* identified) {
  if (options.structure) {
    identified->structure = StructureIn(task, *options.structure, options.also_free);
    identified->fit = FitBlocks(task.logs, identified->structure, task.fit);
    identified->fitted.structure = std::string(Name(*options.structure));
    return;
  }
  identified->ladder = ClimbLadder(task.logs, task.dofs, SearchIn(task));
  const LadderRung& accepted = identified->ladder->rungs[identified->ladder->accepted];
  identified->structure = accepted.structure;
  identified->fit = accepted.fit;
  identified->fitted.structure = "auto";
}

// What a model file holds of a usable fit.
void FillFittedModel(const IdentificationTask& task,
                     const CoupledSummary& fit,
                     FittedCoupledModel* fitted) {
  fitted->model = fit.model;
  fitted->model.dofs = task.dofs;
  fitted->entries = fit.entries;
  fitted->covariance = fit.covariance;
  fitted->force_unit = task.unit_fin.value_or(task.logs.data.front().force_unit);
  fitted->horizon = task.fit.window;
  fitted->residual_autoregression = fit.colour_of_uncoupled;
  for (const ChannelNoise& noise : fit.noise) {
    if (noise.channel.kind != FittedChannel::Kind::kVelocity) continue;
    const auto row = static_cast<std::size_t>(noise.channel.row);
    fitted->residual_autoregression[row] = noise.whitener.coefficients();
  }
}

// Free runs of the model and of the ladder's first rung. False if those of the model diverge.
bool Predict(const IdentificationTask& task, CoupledIdentification* identified) {
  FittedCoupledModel& fitted = identified->fitted;
  auto prediction = PredictCoupled(fitted.model, identified->data, task.fit.window);
  if (!prediction) return false;
  fitted.train = prediction->train;
  fitted.held_out = prediction->held_out;
  identified->prediction = std::move(*prediction);
  if (identified->ladder && identified->ladder->rungs.front().fit.converged) {
    CoupledModel diagonal = identified->ladder->rungs.front().fit.model;
    diagonal.dofs = task.dofs;
    identified->diagonal = PredictCoupled(diagonal, identified->data, task.fit.window);
  }
  return true;
}

}  // namespace

CoupledIdentification IdentifyCoupled(std::vector<Log> logs,
                                      const CoupledIdentificationOptions& options) {
  if (logs.empty()) throw InputError("An identification needs at least one log.");
  CoupledIdentification identified;
  FittedCoupledModel& fitted = identified.fitted;
  fitted.log_fingerprints = FingerprintsOf(logs);
  const IdentificationTask task = IdentificationTaskOf(std::move(logs), options.dofs, options.fit);
  identified.remarks = RemarksOn(task.logs.data);
  identified.message = WhyStill(task);
  if (!identified.message.empty()) return identified;
  FitTask(task, options, &identified);
  identified.fit_options = task.fit;
  identified.data = task.logs.data;
  identified.message = identified.fit.message;
  identified.is_usable = identified.fit.IsUsable();
  if (!identified.is_usable) return identified;
  FillFittedModel(task, identified.fit, &fitted);
  fitted.caveats = CaveatsOnModel(fitted, identified.fit, task);
  if (!Predict(task, &identified)) {
    identified.is_usable = false;
    identified.message = "free runs of the model diverge";
    return identified;
  }
  identified.caveats_on_fit =
      CaveatsOnFit(fitted, identified.fit, identified.data, identified.prediction);
  fitted.caveats.insert(
      fitted.caveats.end(), identified.caveats_on_fit.begin(), identified.caveats_on_fit.end());
  return identified;
}

}  // namespace fathom
