// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/wrench_judge.h"

#include "fathom/coupled_planning/given_block.h"
#include "fathom/coupled_planning/kept_wrench.h"
#include "fathom/planning/information.h"

#include <limits>

namespace fathom {
namespace {

constexpr double kShareOfEntries = 0.3;  // beside rivals

CoupledLimits Narrowed(CoupledLimits limits, double share) {
  for (double& speed : limits.speed) speed *= share;
  for (ValueRange& range : limits.room) range = {share * range.low, share * range.high};
  limits.tilt *= share;
  limits.heading *= share;
  return limits;
}

class JudgeOfWrench : public CommandJudge {
 public:
  JudgeOfWrench(const WrenchQuestion& question, double share)
      : question_(question),
        kept_(question.models, Narrowed(question.limits, share), question.duration),
        information_(question.models.front(), question.entries, question.measurement) {}

  double WorthOf(const std::vector<WrenchBlock>& blocks) override {
    if (blocks.empty()) {
      const auto size = static_cast<Eigen::Index>(question_.entries.size());
      return WorthOfInformation(Eigen::MatrixXd::Zero(size, size));
    }
    const double end = NumCells(blocks) * question_.limits.shortest_hold;
    const auto told = information_.Of(AsCommand(blocks), end);
    return told ? WorthOfInformation(*told) : -std::numeric_limits<double>::infinity();
  }

  bool KeptByOne(const std::vector<WrenchBlock>& blocks) override {
    const CoupledCommand command = AsCommand(blocks);
    return (!question_.thrusters || question_.thrusters->Gives(command)) &&
           kept_.KeptByFirst(command);
  }

  bool KeptByAll(const std::vector<WrenchBlock>& blocks) override {
    return kept_.KeptByAll(AsCommand(blocks));
  }

  WrenchBlock Given(WrenchBlock block) const override {
    if (question_.thrusters) LowerToThrusters(question_.axes, *question_.thrusters, &block);
    return block;
  }

 private:
  CoupledCommand AsCommand(const std::vector<WrenchBlock>& blocks) const {
    return CommandOf(question_.axes, blocks, question_.limits.shortest_hold);
  }

  double WorthOfInformation(const Eigen::MatrixXd& told) const {
    const Eigen::Index num_of_model = question_.so_far.rows();
    const double of_entries =
        LogDetOf(told.topLeftCorner(num_of_model, num_of_model) + question_.so_far);
    if (question_.rivals.empty()) return of_entries;
    return WorthOfSigmas(SigmasOf(question_.rivals, num_of_model, told)) +
           kShareOfEntries * of_entries / static_cast<double>(num_of_model);
  }

  const WrenchQuestion& question_;
  KeptWrench kept_;
  WrenchInformation information_;
};

}  // namespace

std::unique_ptr<CommandJudge> WrenchJudge(const WrenchQuestion& question, double share) {
  return std::make_unique<JudgeOfWrench>(question, share);
}

}  // namespace fathom
