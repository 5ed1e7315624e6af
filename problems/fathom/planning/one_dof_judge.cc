// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/one_dof_judge.h"

#include "fathom/planning/kept_limits.h"
#include "fathom/planning/planned_motion.h"

#include <algorithm>

namespace fathom {
namespace {

PlanLimits Narrowed(PlanLimits limits, double share) {
  limits.speed *= share;
  limits.distance.low *= share;
  limits.distance.high *= share;
  return limits;
}

class JudgeOfOneDof : public CommandJudge {
 public:
  JudgeOfOneDof(const OneDofQuestion& question, double share)
      : dof_(question.dof),
        limits_(Narrowed(question.limits, share)),
        models_(question.models),
        measure_(question.measure),
        stamps_(question.stamps),
        limit_stamps_(question.limit_stamps) {}

  double WorthOf(const std::vector<WrenchBlock>& blocks) override {
    if (blocks.empty()) return measure_({}, {});
    const double end = NumCells(blocks) * limits_.shortest_hold;
    return measure_(
        CommandOf(blocks),
        {stamps_.begin(), std::upper_bound(stamps_.begin(), stamps_.end(), end + 1e-9)});
  }

  bool KeptByOne(const std::vector<WrenchBlock>& blocks) override {
    return Keeps(models_.front(), CommandOf(blocks));
  }

  // A model that breaks them is asked first from then on.
  bool KeptByAll(const std::vector<WrenchBlock>& blocks) override {
    const HeldCommand command = CommandOf(blocks);
    const auto breaking = std::find_if(
        models_.begin(), models_.end(), [&](const auto& model) { return !Keeps(model, command); });
    if (breaking == models_.end()) return true;
    std::rotate(models_.begin(), breaking, breaking + 1);
    return false;
  }

 private:
  HeldCommand CommandOf(const std::vector<WrenchBlock>& blocks) const {
    return CommandOfCells(ForcesAlong(blocks, 0), limits_.shortest_hold);
  }

  bool Keeps(const ExtendedModel& model, const HeldCommand& command) const {
    const auto motion = MotionUnder(model, dof_, command, limit_stamps_);
    return motion && KeepsLimits(*motion, limits_);
  }

  Dof dof_;
  PlanLimits limits_;
  std::vector<ExtendedModel> models_;  // in the order in which they are asked
  const CommandMeasure& measure_;
  const std::vector<double>& stamps_;
  const std::vector<double>& limit_stamps_;
};

}  // namespace

std::unique_ptr<CommandJudge> OneDofJudge(const OneDofQuestion& question, double share) {
  return std::make_unique<JudgeOfOneDof>(question, share);
}

}  // namespace fathom
