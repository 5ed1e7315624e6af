// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/interval95.h"
#include "fathom/ordinary_dives/judge_dives.h"
#include "fathom/ordinary_dives/ordinary_text.h"
#include "fathom/ordinary_dives/run_normal.h"
#include "fathom/ordinary_dives/simple_manoeuvres.h"
#include "fathom/output_error/output_error.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "tank_trial.h"
#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const UncoupledModel<double> kTruth = {850.0, 60.0, 40.0, 1.5};

// A dive of so many seconds under this command, with noise of 0.01 m/s at 10 Hz.
Segment Dive(double duration,
             const std::function<double(double)>& force,
             std::uint64_t seed,
             double correlation = 0.0) {
  HeldCommand command;
  for (int i = 0; i < std::round(duration * 10.0); ++i) {
    command.time.push_back(0.1 * i);
    command.value.push_back(force(0.1 * i));
  }
  return MeasuredRun(RunTruth(kTruth, command, duration), command, seed, correlation);
}

// Now and then a push, as a pilot does who looks at things: six minutes.
double LazyPilot(double t) {
  const double into = std::fmod(t, 45.0);
  const int turn = static_cast<int>(t / 45.0);
  const double size = 20.0 + 9.0 * (turn % 4);
  if (into < 12.0) return turn % 3 == 0 ? size : -size;
  return into < 20.0 ? 0.4 * size : 0.0;
}

// 20 N for long, which quadratic damping has little part in; 260 N from 180 to 200 s and back.
double OneSprint(double t) {
  if (t >= 180.0 && t < 200.0) return 260.0;
  if (t >= 200.0 && t < 212.0) return -260.0;
  const double into = std::fmod(t, 30.0);
  return into < 10.0 ? 20.0 : into < 20.0 ? -12.0 : 0.0;
}

OutputErrorSummary FitOf(const std::vector<Segment>& segments) {
  OutputErrorOptions options;
  options.initial_guess = UncoupledModel<double>{800.0, 50.0, 50.0, 0.0};
  return FitOutputError(segments, options);
}

OrdinaryRequest RequestFor(const std::vector<Segment>& segments) {
  const OutputErrorSummary summary = FitOf(segments);
  EXPECT_TRUE(summary.IsUsable()) << summary.message;
  OrdinaryRequest request;
  request.model.force_unit = "N";
  request.model.model = summary.model;
  request.model.covariance = summary.covariance;
  request.name = "the fit";
  for (std::size_t k = 0; k < segments.size(); ++k) {
    request.logs.push_back("dive_" + std::to_string(k + 1));
    request.spans.push_back({segments[k].time.front(), segments[k].time.back()});
    request.log_of_segment.push_back(k);
  }
  request.segments = segments;
  return request;
}

// The truth is a fit of just these stretches: it reports its own intervals.
void ExpectIntervalsOfFits(const OrdinaryRequest& request, const OrdinaryDives& dives) {
  std::vector<Segment> parts;
  for (const std::size_t k : dives.chosen) {
    const OrdinaryStretch& stretch = dives.stretches[k];
    parts.push_back(SegmentOfStretch(stretch.stretch, request.segments));
    const OutputErrorSummary together = FitOf(parts);
    ASSERT_TRUE(together.IsUsable()) << together.message;
    for (int i = 0; i < kNumParameters; ++i) {
      const double forecast = stretch.together.stds[static_cast<std::size_t>(i)];
      EXPECT_NEAR(forecast / std::sqrt(together.covariance(i, i)), 1.0, 0.2)
          << kParameterInfo[i].name << " after choice " << stretch.place;
    }
  }
}

TEST(JudgeDives, ForecastsTheIntervalsOfAFitOfTheChosenStretches) {
  const OrdinaryRequest request =
      RequestFor({Dive(360.0, LazyPilot, 3), Dive(240.0, OneSprint, 4)});
  const OrdinaryDives dives = JudgeDives(request);
  ASSERT_TRUE(dives.IsUsable()) << dives.message;
  ASSERT_GE(dives.chosen.size(), 1U);
  EXPECT_FALSE(dives.is_position);
  // 6000 samples tell their noise to 1 %.
  EXPECT_NEAR(dives.noise, kTankNoise, 0.03 * kTankNoise);
  ExpectIntervalsOfFits(request, dives);
  for (std::size_t i = 0; i < dives.parameters.size(); ++i) {
    EXPECT_NEAR(dives.all.stds[i] / dives.parameters[i].by_fit, 1.0, 0.1)
        << dives.parameters[i].name;
  }
}

TEST(JudgeDives, ForecastsThemUnderColouredNoiseToo) {
  const OrdinaryRequest request = RequestFor({Dive(600.0, LazyPilot, 5, 0.7)});
  const OrdinaryDives dives = JudgeDives(request);
  ASSERT_TRUE(dives.IsUsable()) << dives.message;
  // Of 6000 samples, to 0.01.
  EXPECT_NEAR(dives.neighbour_correlation, 0.7, 0.05);
  for (std::size_t i = 0; i < dives.parameters.size(); ++i) {
    EXPECT_NEAR(dives.all.stds[i] / dives.parameters[i].by_fit, 1.0, 0.1)
        << dives.parameters[i].name;
  }
  ExpectIntervalsOfFits(request, dives);
  for (const Remedy& remedy : dives.remedies) {
    EXPECT_NE(remedy.kind, RemedyKind::kFasterRate);
    EXPECT_NE(remedy.kind, RemedyKind::kPosition);
  }
}

TEST(JudgeDives, NamesTheStretchFirstThatAloneExcitesTheQuadraticDamping) {
  const OrdinaryRequest request = RequestFor({Dive(420.0, OneSprint, 7)});
  const OrdinaryDives dives = JudgeDives(request);
  ASSERT_TRUE(dives.IsUsable()) << dives.message;
  ASSERT_GT(dives.stretches.size(), 3U);
  const OrdinaryStretch& first = dives.stretches[dives.chosen.front()];
  EXPECT_TRUE(first.time.Contains(190.0)) << first.time.from << " to " << first.time.to;
  EXPECT_EQ(first.place, 1);
  const std::string sentence = OrdinarySentence(request, dives);
  EXPECT_THAT(sentence,
              HasSubstr(std::to_string(std::lround(first.time.from)) + " to " +
                        std::to_string(std::lround(first.time.to)) + " s"));
  for (const OrdinaryStretch& other : dives.stretches) {
    if (other.place == 1) continue;
    EXPECT_GT(other.alone.stds[kQuadraticDamping], 3.0 * first.alone.stds[kQuadraticDamping]);
  }
}

// A remedy is a forecast too: twice the dives, and four times the rate, are made and fitted.
TEST(JudgeDives, ForecastsWhatMoreDivesAndAFasterRateGive) {
  const auto slow_pilot = [](double t) { return 0.5 * LazyPilot(t); };
  const OrdinaryRequest request = RequestFor({Dive(180.0, slow_pilot, 8)});
  const OrdinaryDives dives = JudgeDives(request);
  ASSERT_TRUE(dives.IsUsable()) << dives.message;
  double of_more = 0.0, of_rate = 0.0, of_position = 0.0, of_manoeuvre = 0.0;
  for (const Remedy& remedy : dives.remedies) {
    if (remedy.kind == RemedyKind::kMoreOfTheSame) of_more = remedy.share;
    if (remedy.kind == RemedyKind::kFasterRate) of_rate = remedy.share;
    if (remedy.kind == RemedyKind::kPosition) of_position = remedy.share;
    if (remedy.kind == RemedyKind::kManoeuvre) of_manoeuvre = remedy.share;
  }
  EXPECT_NEAR(of_more / dives.all.share, std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(of_rate / dives.all.share, 0.5, 1e-6);
  EXPECT_LT(of_manoeuvre, dives.all.share);

  // Displacements of 2 cm, fitted to: the random numbers of another dive's noise.
  Segment with_positions = request.segments.front();
  const Segment noise = Dive(
      180.0, [](double) { return 0.0; }, 11);
  const TrueRun still = RunTruth(kTruth, {{0.0}, {0.0}}, 180.0);
  const TrueRun run = RunTruth(kTruth, with_positions.command, 180.0);
  for (std::size_t i = 0; i < run.time.size(); ++i) {
    const double unit = (noise.velocity[i] - still.velocity[i]) / kTankNoise;
    with_positions.position.push_back(run.displacement[i] + 0.02 * unit);
  }
  OutputErrorOptions options;
  options.initial_guess = kTruth;
  options.output = FittedOutput::kPosition;
  const OutputErrorSummary fitted = FitOutputError({&with_positions, 1}, options);
  ASSERT_TRUE(fitted.IsUsable()) << fitted.message;
  const auto weakest = static_cast<Eigen::Index>(dives.all.weakest);
  const double share = kStdsOf95 * std::sqrt(fitted.covariance(weakest, weakest)) /
                       dives.parameters[dives.all.weakest].size;
  EXPECT_NEAR(of_position / share, 1.0, 0.2);

  // The same log, judged by its positions.
  OrdinaryRequest by_position = request;
  by_position.model.model = fitted.model;
  by_position.segments = {with_positions};
  const OrdinaryDives judged = JudgeDives(by_position);
  ASSERT_TRUE(judged.IsUsable()) << judged.message;
  EXPECT_TRUE(judged.is_position);
  EXPECT_NEAR(judged.noise, 0.02, 0.002);
  EXPECT_NEAR(judged.all.stds[dives.all.weakest] / std::sqrt(fitted.covariance(weakest, weakest)),
              1.0,
              0.2);
}

// The manoeuvre is flown beside the dive, and both are fitted.
TEST(JudgeDives, ForecastsWhatAManoeuvreGives) {
  const auto slow_pilot = [](double t) { return 0.5 * LazyPilot(t); };
  const OrdinaryRequest request = RequestFor({Dive(180.0, slow_pilot, 8)});
  const OrdinaryDives dives = JudgeDives(request);
  ASSERT_TRUE(dives.IsUsable()) << dives.message;
  const auto is_manoeuvre = [](const Remedy& one) { return one.kind == RemedyKind::kManoeuvre; };
  const auto remedy = std::ranges::find_if(dives.remedies, is_manoeuvre);
  ASSERT_NE(remedy, dives.remedies.end());
  double force = 0.0, speed = 0.0;
  for (const double f : request.segments[0].command.value) force = std::max(force, std::abs(f));
  for (const double v : request.segments[0].velocity) speed = std::max(speed, std::abs(v));
  int num_found = 0;
  // The greatest speed of the dive is that of 99 % of its samples: sizes may differ by a step.
  for (const double share : {0.9, 0.92, 0.94, 0.96, 0.98, 1.0}) {
    for (const SimpleManoeuvre& manoeuvre :
         SimpleManoeuvres(request.model, force, share * speed, 60.0)) {
      if (remedy->words != "drive for a minute: " + manoeuvre.words || num_found > 0) continue;
      ++num_found;
      const Segment flown =
          MeasuredRun(RunTruth(kTruth, manoeuvre.command, 60.0), manoeuvre.command, 12);
      const OutputErrorSummary fitted = FitOf({request.segments[0], flown});
      ASSERT_TRUE(fitted.IsUsable()) << fitted.message;
      const auto weakest = static_cast<Eigen::Index>(dives.all.weakest);
      const double half_interval = kStdsOf95 * std::sqrt(fitted.covariance(weakest, weakest));
      EXPECT_NEAR(
          remedy->share * dives.parameters[dives.all.weakest].size / half_interval, 1.0, 0.2)
          << manoeuvre.words;
    }
  }
  EXPECT_EQ(num_found, 1) << remedy->words;
}

// Samples from 20 to 100 s; the log holds out what it has from 0 to 20 s, and from 100 to 130 s.
OrdinaryDives TwoOfThreeStretches(std::size_t log_index, OrdinaryDives dives = {}) {
  for (const auto& [from, to, place] :
       {std::tuple(20.0, 50.0, 1), std::tuple(50.0, 75.0, 0), std::tuple(75.0, 100.05, 2)}) {
    OrdinaryStretch stretch;
    stretch.log_index = log_index;
    stretch.time = {from, to};
    stretch.place = place;
    if (place > 0) dives.chosen.push_back(dives.stretches.size());
    dives.stretches.push_back(stretch);
  }
  return dives;
}

TEST(HowToFitChosen, HoldsOutWhatTheLogHoldsOutTooAndReadsTheSameData) {
  OrdinaryRequest request;
  request.logs = {"dive"};
  request.spans = {{0.0, 130.0}};
  EXPECT_THAT(HowToFitChosen(request, TwoOfThreeStretches(0)),
              ElementsAre("fathom_identify --log=dive --dof=surge "
                          "--held_out=0.00:20.00,50.00:75.00,100.05:130.01"));
  request.spans = {{20.0, 100.0}};
  request.logs = {"my dive"};
  request.data_flags = " --correct=u:2";
  EXPECT_THAT(
      HowToFitChosen(request, TwoOfThreeStretches(0)),
      ElementsAre(
          "fathom_identify --log='my dive' --correct=u:2 --dof=surge --held_out=50.00:75.00"));
}

TEST(HowToFitChosen, FitsSeveralLogsAsOne) {
  OrdinaryRequest request;
  request.logs = {"a", "b", "c"};
  request.spans = {{20.0, 100.0}, {20.0, 100.0}, {0.0, 100.0}};
  EXPECT_THAT(HowToFitChosen(request, TwoOfThreeStretches(2, TwoOfThreeStretches(0))),
              ElementsAre("held_out: [[50.00, 75.00]] in the log.yaml of a",
                          "held_out: [[0.00, 20.00], [50.00, 75.00]] in the log.yaml of c",
                          "fathom_identify --log=a --log=c --dof=surge"));
}

// Nothing is commanded: nothing tells the inertia.
TEST(JudgeDives, SaysWhereNoStretchTells) {
  OrdinaryRequest request = RequestFor({Dive(120.0, LazyPilot, 3)});
  const std::vector<double> noise = Dive(
                                        60.0, [](double) { return kTruth.buoyancy; }, 9)
                                        .velocity;  // from rest: it stays
  Segment still;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    still.time.push_back(0.1 * static_cast<double>(i));
    still.velocity.push_back(noise[i]);
  }
  still.command = {{0.0}, {0.0}};
  request.model.model.buoyancy = 0.0;
  request.segments = {still};
  const OrdinaryDives dives = JudgeDives(request);
  EXPECT_FALSE(dives.IsUsable());
  EXPECT_THAT(OrdinarySentence(request, dives), HasSubstr("no stretch of them will"));
}

// A and B of generic columns, by the closed forms; a colour of one coefficient.
TEST(RunNormal, IsThatOfPlainSquaresUnderColouredNoise) {
  constexpr double kPhi = 0.63, kSigma = 0.17;
  constexpr int kRows = 57;
  MotionDerivatives derivatives;
  derivatives.by_parameter.resize(kRows, 3);
  derivatives.by_start.resize(kRows, 1);
  std::vector<double> stamps;
  for (int i = 0; i < kRows; ++i) {
    stamps.push_back(0.3 * i);
    derivatives.by_start(i, 0) = std::exp(-0.07 * i);
    derivatives.by_parameter.row(i) << 2.1 * std::sin(0.31 * i), 0.04 * i, 900.0;
  }
  const RunNoise noise = {false, MeansOf(kSigma, std::vector<double>{kPhi}, 1)};
  const RunNormal normal = NormalOfRun(derivatives, stamps, {0, 2}, noise);
  Eigen::MatrixXd X(kRows, 2), Gamma(kRows, kRows);
  X << derivatives.by_parameter.col(0), derivatives.by_parameter.col(2);
  const Eigen::VectorXd start = derivatives.by_start.col(0).normalized();
  X -= start * (start.transpose() * X);
  for (int i = 0; i < kRows; ++i) {
    for (int k = 0; k < kRows; ++k) Gamma(i, k) = std::pow(kPhi, std::abs(i - k));
  }
  const Eigen::MatrixXd A = X.transpose() * X;
  const Eigen::MatrixXd B = kSigma * kSigma * X.transpose() * Gamma * X;
  EXPECT_LT((normal.A - A).norm(), 1e-9 * A.norm());
  EXPECT_LT((normal.B - B).norm(), 1e-6 * B.norm());
  const Eigen::MatrixXd expected = A * InverseOfSymmetric(B) * A;
  EXPECT_LT((normal.Information() - expected).norm(), 1e-5 * expected.norm());
  EXPECT_EQ(RunNormal::Zero(2).Information().norm(), 0.0);
}

TEST(OrdinaryText, CountsChoices) {
  EXPECT_EQ(PlaceName(1), "1st");
  EXPECT_EQ(PlaceName(2), "2nd");
  EXPECT_EQ(PlaceName(3), "3rd");
  EXPECT_EQ(PlaceName(8), "8th");
  EXPECT_EQ(PlaceName(11), "11th");
}

TEST(CutAtNaturalEnds, CutsWhereTheVehicleIsSlowAndItsCommandSteady) {
  const std::vector<Segment> dive = {Dive(360.0, LazyPilot, 3)};
  const std::vector<DiveStretch> stretches = CutAtNaturalEnds(dive);
  ASSERT_GE(stretches.size(), 4U);
  EXPECT_EQ(stretches.front().begin, 0U);
  EXPECT_EQ(stretches.back().end, dive.front().time.size());
  double unrest = 0.0;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const TimeInterval time = TimeOf(stretches[k], dive);
    EXPECT_GE(time.to - time.from, 30.0 - 0.1);
    EXPECT_LE(time.to - time.from, 120.0 + 0.1);
    if (k == 0) continue;
    EXPECT_EQ(stretches[k].begin, stretches[k - 1].end);
    unrest += std::abs(dive.front().velocity[stretches[k].begin]);
    // Pushes begin every 45 s and are let go of 12 and 20 s later.
    const double into = std::fmod(time.from, 45.0);
    for (const double change : {12.0, 20.0}) EXPECT_GT(std::abs(into - change), 0.9) << time.from;
  }
  double usual = 0.0;
  for (const double velocity : dive.front().velocity) usual += std::abs(velocity);
  usual /= static_cast<double>(dive.front().velocity.size());
  EXPECT_LT(unrest / static_cast<double>(stretches.size() - 1), 0.5 * usual);
}

TEST(CutAtNaturalEnds, LeavesAShortSegmentWhole) {
  const std::vector<Segment> dives = {Dive(21.0, LazyPilot, 3), Dive(44.0, LazyPilot, 4)};
  const std::vector<DiveStretch> stretches = CutAtNaturalEnds(dives);
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_EQ(stretches[1].segment_index, 1U);
  EXPECT_EQ(SegmentOfStretch(stretches[1], dives).time, dives[1].time);
}

}  // namespace
}  // namespace fathom
