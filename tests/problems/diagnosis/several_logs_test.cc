// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What belongs to a run, in one of several logs that are diagnosed together.

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/diagnosis/data/training_data.h"
#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/measures/held_out.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/log/distinct_names.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "surge_run.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

constexpr double kJump = 15.0;  // [N]

Log RunOf(const std::string& name, const std::string& effects, int seed) {
  SurgeRun run;
  run.name = name;
  run.input = Multisine(40.0);
  run.duration = 150.0;
  run.effects = effects;
  return LogOf(run, seed);
}

Log WithJump(const std::string& name, double time, int seed) {
  return RunOf(name, "buoyancy_step:jump=15:time=" + std::to_string(time), seed);
}

std::vector<std::string> LabelsOf(const ExtendedModel& model) {
  std::vector<std::string> labels;
  for (const ActiveEffect& active : model.effects) {
    labels.push_back(LabelOf(active.effect->info(), active.setting));
  }
  return labels;
}

std::vector<std::string> LabelsOf(const std::vector<Suspect>& suspects) {
  std::vector<std::string> labels;
  for (const Suspect& suspect : suspects) labels.push_back(LabelOf(suspect));
  return labels;
}

// The jump within four standard deviations of 15 N, its time within a second.
void ExpectJump(const Diagnosis& diagnosis, const std::string& log, double time) {
  Eigen::Index index = kNumParameters;
  int num_found = 0;
  for (const ActiveEffect& active : diagnosis.extended.model.effects) {
    if (active.setting.log == log) {
      const double std = std::sqrt(diagnosis.extended.covariance(index, index));
      EXPECT_EQ(active.effect->info().name, "buoyancy_step");
      EXPECT_NEAR(active.values[0], kJump, 4.0 * std) << log;
      EXPECT_LT(std, 2.0) << log;
      EXPECT_NEAR(active.values[1], time, 1.0) << log;
      ++num_found;
    }
    index += static_cast<Eigen::Index>(active.values.size());
  }
  EXPECT_EQ(num_found, 1) << log;
}

TEST(SeveralLogs, HaveTheirOwnJumpsEachAtItsTime) {
  const std::vector<Log> logs = {WithJump("early", 50.0, 1), WithJump("late", 100.0, 2)};
  const Diagnosis diagnosis = Diagnose(logs, Dof::kSurge);
  EXPECT_EQ(diagnosis.verdict, Verdict::kExplained);
  EXPECT_THAT(LabelsOf(diagnosis.extended.model),
              UnorderedElementsAre("buoyancy_step(early)", "buoyancy_step(late)"));
  ExpectJump(diagnosis, "early", 50.0);
  ExpectJump(diagnosis, "late", 100.0);
  EXPECT_GT(diagnosis.held_out_gain, 0.2);
  EXPECT_GT(diagnosis.held_out_gain_low, 0.0);
}

TEST(SeveralLogs, AreLeftAloneByAJumpInAnother) {
  for (const bool jump_comes_first : {true, false}) {
    std::vector<Log> logs = {WithJump("jumped", 60.0, 3), RunOf("clean", "", 4)};
    if (!jump_comes_first) std::reverse(logs.begin(), logs.end());
    const Diagnosis diagnosis = Diagnose(logs, Dof::kSurge);
    EXPECT_EQ(diagnosis.verdict, Verdict::kExplained);
    EXPECT_THAT(LabelsOf(diagnosis.extended.model), ElementsAre("buoyancy_step(jumped)"));
    ExpectJump(diagnosis, "jumped", 60.0);
    EXPECT_GT(diagnosis.held_out_gain_low, 0.0);
  }
}

// What the vehicle has, all logs have.
TEST(SeveralLogs, ShareWhatBelongsToTheVehicle) {
  const std::vector<Log> logs = {RunOf("first", "thrust_dead_zone:width=12", 5),
                                 RunOf("second", "thrust_dead_zone:width=12", 6)};
  const Diagnosis diagnosis = Diagnose(logs, Dof::kSurge);
  EXPECT_THAT(LabelsOf(diagnosis.extended.model), ElementsAre("thrust_dead_zone"));
}

// One run reverses badly, as with weed in its thrusters, and is long enough to speak for all in a
// fit to all. The others contradict it, and so does a run that nobody has seen.
TEST(SeveralLogs, NameNothingThatTheOthersDoNotConfirm) {
  SurgeRun weedy;
  weedy.name = "weedy";
  weedy.input = Multisine(40.0);
  weedy.duration = 300.0;
  weedy.effects = "thrust_asymmetry:reverse_loss=0.5";
  const std::vector<Log> logs = {
      LogOf(weedy, 21), RunOf("clean", "", 22), RunOf("clean too", "", 23)};
  DiagnosisOptions options;
  options.effects = {FindEffect("thrust_asymmetry")};
  const Diagnosis diagnosis = Diagnose(logs, Dof::kSurge, options);
  EXPECT_TRUE(diagnosis.by_left_out_logs);
  EXPECT_EQ(diagnosis.verdict, Verdict::kUnexplained);
  EXPECT_THAT(diagnosis.causes, IsEmpty());
  ASSERT_TRUE(diagnosis.not_named.has_value());
  EXPECT_EQ(diagnosis.not_named->label, "thrust_asymmetry");
  const auto unseen = MeasuredSegmentsOf(std::vector{RunOf("unseen", "", 24)}, Dof::kSurge);
  const auto error = [&](const ExtendedModel& model) {
    const auto run = FreeRunOver(unseen.all.front(), model);
    return FiguresOfRuns(std::vector{run.value()}).mae;
  };
  EXPECT_LT(error(diagnosis.extended.model), 1.02 * error(diagnosis.baseline.model));
}

// The part of a log that is held out is of the same run, the other log is not.
TEST(SeveralLogs, CarryWhatBelongsToARunIntoTheirHeldOutParts) {
  std::vector<Log> logs = {WithJump("jumped", 40.0, 7), RunOf("clean", "", 8)};
  for (Log& log : logs) log.held_out = {{110.0, 150.0}};
  const MeasuredSegments segments = MeasuredSegmentsOf(logs, Dof::kSurge);
  const ExtendedModel without = {kSurgeTruth, {}};
  const ExtendedModel with = {
      kSurgeTruth,
      {{FindEffect("buoyancy_step"), {.dof = Dof::kSurge, .log = "jumped"}, {kJump, 40.0}}}};
  for (const MeasuredSegment& segment : segments.all) {
    if (!segment.is_held_out) continue;
    const auto error = [&](const ExtendedModel& model) {
      const auto run = FreeRunOver(segment, model);
      return FiguresOfRuns(std::vector{*run}).mae;
    };
    if (segment.log == "jumped") {
      EXPECT_LT(error(with), 0.3 * error(without));
    } else {
      EXPECT_EQ(error(with), error(without));
    }
  }
  const Diagnosis diagnosis = Diagnose(logs, Dof::kSurge);
  EXPECT_FALSE(diagnosis.by_left_out_blocks);
  EXPECT_THAT(LabelsOf(diagnosis.extended.model), ElementsAre("buoyancy_step(jumped)"));
  EXPECT_GT(diagnosis.held_out_gain_low, 0.0);
}

// Rows of the other log neither move nor depend on the parameters.
TEST(SeveralLogs, DoNotMoveWithAnEffectOfAnother) {
  const std::vector<Log> logs = {RunOf("first", "", 9), RunOf("second", "", 10)};
  const TrainingData data(MeasuredSegmentsOf(logs, Dof::kSurge).all);
  const std::vector<InitialState> initial = {data.segments()[0].initial,
                                             data.segments()[1].initial};
  for (const Effect* effect : EffectCatalogue()) {
    if (effect->info().scope != Scope::kRun || effect->info().needs_pose) continue;
    std::vector<double> values;
    for (const EffectParameter& parameter : effect->info().parameters) {
      values.push_back(parameter.search == Search::kTimeOfRun ? 50.0 : 0.02);
    }
    const ExtendedModel model = {kSurgeTruth,
                                 {{effect, {.dof = Dof::kSurge, .log = "second"}, values}}};
    const auto with = data.Linearise(model, initial);
    const auto without = data.Simulate({kSurgeTruth, {}}, initial);
    ASSERT_TRUE(with && without) << effect->info().name;
    const Eigen::Index of_first = data.bins().first_row(1);
    const Eigen::Index num_second = data.bins().size() - of_first;
    const auto num_values = static_cast<Eigen::Index>(values.size());
    // Derivatives are carried along in other arithmetic.
    EXPECT_LT((with->simulated - *without).head(of_first).norm(), 1e-9) << effect->info().name;
    EXPECT_EQ(with->jacobian.topRows(of_first).middleCols(kNumParameters, num_values).norm(), 0.0);
    EXPECT_GT((with->simulated - *without).tail(num_second).norm(), 1e-3) << effect->info().name;
    const auto own = data.SimulateLog("second", model, initial, *without);
    ASSERT_TRUE(own);
    EXPECT_LT((*own - with->simulated).norm(), 1e-9) << effect->info().name;
  }
}

TEST(SuspectsFor, AreOfEachLogWhereTheyBelongToARunAndThereAreSeveral) {
  const std::vector<Log> logs = {RunOf("first", "", 11), RunOf("second", "", 12)};
  const auto suspects_of = [](std::span<const Log> some) {
    return LabelsOf(
        SuspectsFor(MeasuredSegmentsOf(some, Dof::kSurge), Dof::kSurge, EffectCatalogue()));
  };
  const auto of_two = suspects_of(logs);
  EXPECT_THAT(of_two, Contains("thruster_lag"));
  EXPECT_THAT(of_two, Contains("buoyancy_step(first)"));
  EXPECT_THAT(of_two, Contains("buoyancy_step(second)"));
  EXPECT_THAT(of_two, Not(Contains("buoyancy_step")));
  const auto of_one = suspects_of(std::span(logs).first(1));
  EXPECT_THAT(of_one, Contains("buoyancy_step"));
  EXPECT_EQ(std::count_if(of_one.begin(),
                          of_one.end(),
                          [](const std::string& label) { return label.ends_with(')'); }),
            0);
}

TEST(MeasuredSegmentsOf, TellsLogsOfOneNameByTheirFolders) {
  std::vector<Log> logs = {RunOf("dive", "", 13), RunOf("dive", "", 14), RunOf("test", "", 15)};
  logs[0].path = "monday/dive";
  logs[1].path = "tuesday/dive";
  logs[2].path = "tuesday/test";
  const std::vector<std::string> names = {"dive (monday/dive)", "dive (tuesday/dive)", "test"};
  const MeasuredSegments segments = MeasuredSegmentsOf(logs, Dof::kSurge);
  EXPECT_EQ(segments.logs, names);
  ASSERT_EQ(segments.all.size(), 3u);
  for (size_t k = 0; k < 3; ++k) EXPECT_EQ(segments.all[k].log, names[k]);
  logs[1].path = logs[0].path;
  EXPECT_NE(DistinctNames(logs)[0], DistinctNames(logs)[1]);
}

// One run's vehicle was heavier. Birge's rule by hand, on what each run says alone: the weighted
// mean's deviation times how far the runs scatter by it.
TEST(SeveralLogs, HaveABaselineWithIntervalsAsWideAsTheyDiffer) {
  DiagnosisOptions options;
  options.effects = {FindEffect("thruster_lag")};
  std::vector<Log> logs;
  double weights = 0.0, sum = 0.0, sum_of_squares = 0.0;
  for (int k = 0; k < 4; ++k) {
    SurgeRun run;
    run.name = "run_" + std::to_string(k);
    run.input = Multisine(40.0);
    run.duration = 150.0;
    run.model.inertia = k == 2 ? 1000.0 : 890.0;
    logs.push_back(LogOf(run, 31 + k));
    const Diagnosis alone = Diagnose(std::span(&logs.back(), 1), Dof::kSurge, options);
    const double value = alone.baseline.model.baseline.inertia;
    const double weight = 1.0 / alone.baseline.covariance(kInertia, kInertia);
    weights += weight;
    sum += weight * value;
    sum_of_squares += weight * value * value;
  }
  const double chi_squared = sum_of_squares - sum * sum / weights;
  const double mean_std = std::sqrt(chi_squared / 3.0 / weights);
  const Diagnosis together = Diagnose(logs, Dof::kSurge, options);
  const double std = std::sqrt(together.baseline.covariance(kInertia, kInertia));
  EXPECT_GT(chi_squared, 30.0);
  EXPECT_NEAR(std, mean_std, 0.02 * mean_std);
  EXPECT_THAT(together.remarks, Contains(testing::HasSubstr("widened: inertia by a factor of ")));
}

}  // namespace
}  // namespace fathom
