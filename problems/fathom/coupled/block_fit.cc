// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/block_fit.h"

#include "fathom/output_error/output_error.h"
#include "fathom/signal/joined_signals.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

using Kind = FreeEntry::Kind;

// The DOFs beside the modelled ones that move.
std::vector<Dof> Partners(std::span<const CoupledData> logs) {
  std::vector<Dof> partners;
  for (const Dof dof : kAllDofs) {
    const bool moves = std::any_of(logs.begin(), logs.end(), [&](const CoupledData& log) {
      return !log.inputs.measured[static_cast<std::size_t>(Index(dof))].time.empty();
    });
    if (moves) partners.push_back(dof);
  }
  return partners;
}

MotionStructure PartOf(const MotionStructure& structure, const std::vector<Dof>& block) {
  MotionStructure part = {block, {}, structure.coriolis};
  for (const FreeEntry& entry : structure.entries) {
    const Dof row = entry.kind == Kind::kNetBuoyancy ? Dof::kHeave : entry.row;
    if (IsOfActuator(entry) || std::find(block.begin(), block.end(), row) != block.end()) {
      part.entries.push_back(entry);
    }
  }
  return part;
}

// Whether a fin or a shaft pushes along a DOF, that of the block.
bool IsSteered(const CoupledData& log, Dof dof) {
  return std::ranges::any_of(
             log.inputs.command.fins,
             [&](const CommandedFin& fin) { return fin.arms.across[Index(dof)] != 0.0; }) ||
         std::ranges::any_of(log.inputs.command.shafts, [&](const CommandedShaft& shaft) {
           return shaft.push[Index(dof)] != 0.0;
         });
}

// Whether a block is one DOF with all four numbers of docs/models.md (1), a command of its own and
// no fin.
bool IsUncoupled(const CoupledLogs& logs, const MotionStructure& part) {
  if (logs.logs.empty() || part.dofs.size() != 1 || part.entries.size() != kNumParameters) {
    return false;
  }
  const auto is_parameter = [](const FreeEntry& entry) { return ParameterOf(entry) >= 0; };
  const auto has_command = [&](const Log& log) {
    return log.command && log.command->Find(ForceColumn(part.dofs.front())) != nullptr;
  };
  const auto is_steered = [&](const CoupledData& log) { return IsSteered(log, part.dofs.front()); };
  return std::all_of(part.entries.begin(), part.entries.end(), is_parameter) &&
         std::none_of(logs.data.begin(), logs.data.end(), is_steered) &&
         std::all_of(logs.logs.begin(), logs.logs.end(), has_command);
}

CoupledSummary FitUncoupled(const CoupledLogs& logs,
                            const MotionStructure& part,
                            const CoupledFitOptions& options) {
  const JoinedSignals joined = JoinSignals(logs.logs, part.dofs.front(), std::nullopt);
  OutputErrorOptions one;
  one.output = OutputOf(joined.all.train);
  one.huber_k = options.huber_k;
  const OutputErrorSummary fit = FitOutputError(joined.all.train, one);
  CoupledSummary summary;
  summary.message = fit.message;
  if (summary.message.ends_with('.')) summary.message.pop_back();
  summary.converged = fit.converged;
  summary.determined = fit.determined;
  summary.model = options.held;
  summary.entries = part.entries;
  summary.num_iterations = fit.num_iterations;
  summary.cost = fit.final_cost;
  if (one.output == FittedOutput::kVelocity) {
    summary.colour_of_uncoupled[static_cast<std::size_t>(Index(part.dofs.front()))] =
        fit.evidence.noise.coefficients;
  }
  const auto size = static_cast<Eigen::Index>(part.entries.size());
  summary.covariance.resize(size, size);
  const ParameterVector values = ToVector(fit.model);
  for (Eigen::Index i = 0; i < size; ++i) {
    const FreeEntry& entry = part.entries[static_cast<std::size_t>(i)];
    const int parameter = ParameterOf(entry);
    SetValue(entry, values[parameter], &summary.model);
    if (fit.on_bound[static_cast<std::size_t>(parameter)]) summary.on_bound.push_back(entry);
    for (Eigen::Index j = 0; j < size; ++j) {
      summary.covariance(i, j) =
          fit.covariance(parameter, ParameterOf(part.entries[static_cast<std::size_t>(j)]));
    }
  }
  return summary;
}

// The log with the DOFs of one block; the others move as measured.
std::vector<CoupledData> WithDofs(std::span<const CoupledData> logs,
                                  const std::vector<Dof>& block) {
  std::vector<CoupledData> out;
  for (const CoupledData& log : logs) {
    CoupledData& part = out.emplace_back(log);
    for (const Dof dof : log.dofs) {
      if (std::find(block.begin(), block.end(), dof) != block.end()) continue;
      SampledSignal& measured = part.inputs.measured[static_cast<std::size_t>(Index(dof))];
      for (const CoupledSegment& segment : log.segments) {
        for (std::size_t i = 0; i < segment.time.size(); ++i) {
          const double value = segment.velocity[i][Index(dof)];
          if (!std::isfinite(value)) continue;
          measured.time.push_back(segment.time[i]);
          measured.value.push_back(value);
        }
      }
    }
    part.dofs = block;
  }
  return out;
}

void AddBlock(const CoupledSummary& block, const MotionStructure& structure, CoupledSummary* all) {
  for (std::size_t i = 0; i < block.entries.size(); ++i) {
    SetValue(block.entries[i], ValueIn(block.model, block.entries[i]), &all->model);
    const auto place = [&](std::size_t k) {
      return std::find(structure.entries.begin(), structure.entries.end(), block.entries[k]) -
             structure.entries.begin();
    };
    for (std::size_t j = 0; j < block.entries.size(); ++j) {
      all->covariance(place(i), place(j)) =
          block.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  all->on_bound.insert(all->on_bound.end(), block.on_bound.begin(), block.on_bound.end());
  all->open_inertias.insert(
      all->open_inertias.end(), block.open_inertias.begin(), block.open_inertias.end());
  all->undetermined.insert(
      all->undetermined.end(), block.undetermined.begin(), block.undetermined.end());
  all->priors.insert(all->priors.end(), block.priors.begin(), block.priors.end());
  all->noise.insert(all->noise.end(), block.noise.begin(), block.noise.end());
  for (std::size_t row = 0; row < all->colour_of_uncoupled.size(); ++row) {
    if (block.colour_of_uncoupled[row]) {
      all->colour_of_uncoupled[row] = block.colour_of_uncoupled[row];
    }
  }
  all->num_iterations += block.num_iterations;
  all->num_rows += block.num_rows;
  all->cost += block.cost;
  if (!block.IsUsable() && all->IsUsable()) {
    all->message = fmt::format("{}: {}", Name(block.model.dofs.front()), block.message);
  }
  all->converged = all->converged && block.converged;
  all->determined = all->determined && block.determined;
}

// One block, or all of them together.
CoupledSummary FitPart(const CoupledLogs& logs,
                       const std::vector<CoupledData>& data,
                       const MotionStructure& part,
                       const CoupledFitOptions& options) {
  if (IsUncoupled(logs, part)) {
    CoupledSummary fit = FitUncoupled(logs, part, options);
    if (fit.IsUsable()) return fit;
  }
  return FitCoupled(data, part, options);
}

CoupledSummary FitAll(const CoupledLogs& logs,
                      const MotionStructure& structure,
                      const CoupledFitOptions& options) {
  const auto blocks = BlocksOf(structure, Partners(logs.data), options.held);
  const bool has_gain =
      std::any_of(structure.entries.begin(), structure.entries.end(), IsOfActuator);
  // A shaft's thrust goes by the flow of all DOFs along it.
  const bool has_shaft = std::ranges::any_of(
      logs.data, [](const CoupledData& log) { return !log.inputs.command.shafts.empty(); });
  if (blocks.size() == 1 || has_gain || has_shaft) {
    return FitPart(logs, logs.data, structure, options);
  }
  CoupledSummary summary;
  const auto size = static_cast<Eigen::Index>(structure.entries.size());
  summary.model = options.held;
  summary.model.dofs = structure.dofs;
  summary.model.coriolis = structure.coriolis;
  summary.entries = structure.entries;
  summary.covariance = Eigen::MatrixXd::Zero(size, size);
  summary.converged = summary.determined = true;
  summary.message = "converged";
  summary.cost = 0.0;
  for (const std::vector<Dof>& block : blocks) {
    const MotionStructure part = PartOf(structure, block);
    CoupledSummary of_block = FitPart(logs, WithDofs(logs.data, block), part, options);
    of_block.model.dofs = block;
    AddBlock(of_block, structure, &summary);
  }
  return summary;
}

}  // namespace

CoupledSummary FitBlocks(const CoupledLogs& logs,
                         const MotionStructure& structure,
                         const CoupledFitOptions& options) {
  CoupledSummary fit = FitAll(logs, structure, options);
  const auto priors = InertiasAlike(fit.model, fit.open_inertias, structure.entries);
  if (priors.empty()) return fit;
  CoupledFitOptions again = options;
  again.priors.insert(again.priors.end(), priors.begin(), priors.end());
  CoupledSummary held = FitAll(logs, structure, again);
  return held.IsUsable() || !fit.IsUsable() ? held : fit;
}

}  // namespace fathom
