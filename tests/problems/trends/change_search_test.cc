// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/change_search.h"

#include "fathom/trends/name_causes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "drawn_archive.h"
#include "side_by_side.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

// Scatter between dives as turbulence makes it, in some parameters only.
DrawnArchive TurbulentArchive() {
  DrawnArchive archive;
  archive.tau << 0.0, 2.0, 0.0, 0.5;
  return archive;
}

TEST(ChangeSearch, OneQuietArchiveInTwentyHasAChange) {
  const int num_archives = 1000;
  ChangeOptions options;
  options.num_draws = 199;
  std::vector<char> has_change(num_archives), has_outlier(num_archives);
  SideBySide(num_archives, 2, [&](std::size_t i) {
    RandomStream random(i, "archive");
    const ChangeSearch search = FindChanges(DrawQuiet(TurbulentArchive(), &random), 30, options);
    has_change[i] = !search.changes.empty();
    has_outlier[i] = !search.outliers.empty();
  });
  const int changes = std::count(has_change.begin(), has_change.end(), 1);
  const int outliers = std::count(has_outlier.begin(), has_outlier.end(), 1);
  RecordProperty("archives_with_a_change", changes);
  RecordProperty("archives_with_an_outlier", outliers);
  // 50 expected, give or take 6.9.
  EXPECT_GE(changes, 30);
  EXPECT_LE(changes, 70);
  // 10 expected, give or take 3.1.
  EXPECT_LE(outliers, 20);
}

TEST(ChangeSearch, ShortQuietArchivesSeldomHaveAChange) {
  const int num_archives = 300;
  ChangeOptions options;
  options.num_draws = 199;
  DrawnArchive archive = TurbulentArchive();
  archive.num_dives = 12;
  std::vector<char> has_change(num_archives);
  SideBySide(num_archives, 2, [&](std::size_t i) {
    RandomStream random(i, "archive");
    has_change[i] = !FindChanges(DrawQuiet(archive, &random), 12, options).changes.empty();
  });
  // 15 expected, give or take 3.8.
  EXPECT_LE(std::count(has_change.begin(), has_change.end(), 1), 27);
}

// Of drawn archives with one step of 5.5 standard deviations, what is told in the end.
struct FoundSteps {
  int found = 0;
  int placed = 0;        // at its dive, give or take one
  int first_placed = 0;  // the same of the single likeliest dive
};

bool IsAt(int dive, const Change& change) {
  return change.kind == ChangeKind::kStep && std::abs(change.at - dive) <= 1;
}

FoundSteps FindSteps(const DrawnArchive& archive, int num_archives) {
  std::vector<char> is_found(num_archives), is_placed(num_archives), is_first(num_archives);
  const std::vector<std::string> names(archive.num_dives, "dive");
  ChangeOptions options;
  options.num_draws = 199;
  SideBySide(num_archives, 2, [&](std::size_t i) {
    RandomStream random(i, "archive");
    std::vector<DiveEstimate> estimates = DrawQuiet(archive, &random);
    const Dof dof = archive.dofs[static_cast<int>(3 * random.Uniform())];
    const int parameter = static_cast<int>(4 * random.Uniform());
    const int at = 2 + static_cast<int>(27 * random.Uniform());
    // Weights before and after, with the true scatter.
    double before = 0.0, after = 0.0;
    for (const DiveEstimate& estimate : estimates) {
      if (estimate.dof != dof) continue;
      (estimate.dive < at ? before : after) +=
          1.0 / (estimate.covariance(parameter, parameter) + std::pow(archive.tau(parameter), 2));
    }
    const double size =
        (random.Uniform() < 0.5 ? -5.5 : 5.5) * std::sqrt(1.0 / before + 1.0 / after);
    for (DiveEstimate& estimate : estimates) {
      if (estimate.dof == dof && estimate.dive >= at) estimate.value(parameter) += size;
    }
    const ChangeSearch search = FindChanges(estimates, archive.num_dives, options);
    const auto is_it = [&](const Change& change) {
      return change.dof == dof && change.parameter == parameter;
    };
    for (const Change& change : search.changes) {
      is_first[i] = is_first[i] || (is_it(change) && IsAt(at, change));
    }
    for (const ChangeEvent& event : NameCauses(search, estimates, names, {}, options)) {
      for (const Change& change : event.changes) {
        is_found[i] = is_found[i] || is_it(change);
        is_placed[i] = is_placed[i] || (is_it(change) && IsAt(at, change));
      }
    }
  });
  const auto count = [](const std::vector<char>& flags) {
    return static_cast<int>(std::count(flags.begin(), flags.end(), 1));
  };
  return {count(is_found), count(is_placed), count(is_first)};
}

// The rate of 5 % over 200 archives, and two standard deviations of the count more.
TEST(ChangeSearch, FindsNothingInCoupledModelsThatStay) {
  const int num_archives = 200, num_dives = 12;
  std::vector<char> has_change(num_archives);
  SideBySide(num_archives, 2, [&](std::size_t i) {
    RandomStream random(i, "archive");
    const std::vector<DiveEstimate> estimates = DrawQuietCoupled(num_dives, &random);
    ChangeOptions options;
    options.num_draws = 199;
    has_change[i] = FindChanges(estimates, num_dives, options).changes.empty() ? 0 : 1;
  });
  const auto count = std::count(has_change.begin(), has_change.end(), 1);
  RecordProperty("with_change", static_cast<int>(count));
  EXPECT_LE(count, 0.05 * num_archives + 2.0 * std::sqrt(0.05 * num_archives));
}

TEST(ChangeSearch, FindsAStepAtItsDive) {
  const int num_archives = 300;
  const FoundSteps steps = FindSteps(TurbulentArchive(), num_archives);
  RecordProperty("found", steps.found);
  RecordProperty("placed", steps.placed);
  EXPECT_GE(steps.found, 0.9 * num_archives);
  EXPECT_GE(steps.placed, 0.8 * num_archives);
}

// Over thousands of archives nine and eight in ten; here less two standard deviations of the count.
TEST(ChangeSearch, FindsAStepWherePartnersSayNothing) {
  const int num_archives = 400;
  DrawnArchive archive = TurbulentArchive();
  archive.correlation = 0.0;
  const FoundSteps steps = FindSteps(archive, num_archives);
  RecordProperty("found", steps.found);
  RecordProperty("placed", steps.placed);
  EXPECT_GE(steps.found, 0.9 * num_archives - 2.0 * std::sqrt(0.09 * num_archives));
  EXPECT_GE(steps.placed, 0.8 * num_archives - 2.0 * std::sqrt(0.16 * num_archives));
  EXPECT_GT(steps.placed, steps.first_placed);
}

std::vector<DiveEstimate> QuietDives(std::uint64_t seed) {
  RandomStream random(seed, "archive");
  return DrawQuiet(TurbulentArchive(), &random);
}

DiveEstimate& At(int dive, Dof dof, std::vector<DiveEstimate>* estimates) {
  return *std::find_if(estimates->begin(), estimates->end(), [&](const DiveEstimate& estimate) {
    return estimate.dive == dive && estimate.dof == dof;
  });
}

TEST(ChangeSearch, AWildDiveIsAnOutlierAndNoStep) {
  std::vector<DiveEstimate> estimates = QuietDives(2);
  At(14, Dof::kHeave, &estimates).value(kInertia) += 60.0;
  At(29, Dof::kYaw, &estimates).value(kLinearDamping) -= 40.0;  // the last one
  const ChangeSearch search = FindChanges(estimates, 30, {});
  EXPECT_TRUE(search.changes.empty());
  EXPECT_THAT(search.outliers,
              ::testing::UnorderedElementsAre(ParameterOutlier{14, Dof::kHeave, kInertia},
                                              ParameterOutlier{29, Dof::kYaw, kLinearDamping}));
}

TEST(ChangeSearch, AWildDiveHidesNoStep) {
  std::vector<DiveEstimate> estimates = QuietDives(2);
  for (int dive = 20; dive < 30; ++dive) At(dive, Dof::kHeave, &estimates).value(kInertia) += 8.0;
  At(8, Dof::kHeave, &estimates).value(kInertia) += 60.0;
  const ChangeSearch search = FindChanges(estimates, 30, {});
  ASSERT_EQ(search.changes.size(), 1u);
  EXPECT_EQ(search.changes[0].kind, ChangeKind::kStep);
  EXPECT_NEAR(search.changes[0].at, 20, 1);
  EXPECT_THAT(search.outliers, ::testing::ElementsAre(ParameterOutlier{8, Dof::kHeave, kInertia}));
}

TEST(ChangeSearch, ATrendIsNoStackOfSteps) {
  std::vector<DiveEstimate> estimates = QuietDives(3);
  for (DiveEstimate& estimate : estimates) {
    if (estimate.dof == Dof::kSurge) estimate.value(kInertia) += 2.0 * estimate.dive;
  }
  const ChangeSearch search = FindChanges(estimates, 30, {});
  ASSERT_EQ(search.changes.size(), 1u);
  const Change& trend = search.changes[0];
  EXPECT_EQ(trend.kind, ChangeKind::kTrend);
  EXPECT_NEAR(trend.before, 140.0, 4.0 * trend.before_std);
  EXPECT_NEAR(trend.after, 140.0 + 2.0 * 29, 4.0 * trend.after_std);
}

TEST(ChangeSearch, GivesTheSameBitsAgain) {
  std::vector<DiveEstimate> estimates = QuietDives(4);
  for (int dive = 20; dive < 30; ++dive) At(dive, Dof::kSurge, &estimates).value(kInertia) += 6.0;
  const ChangeSearch first = FindChanges(estimates, 30, {});
  const ChangeSearch second = FindChanges(estimates, 30, {});
  ASSERT_EQ(first.changes.size(), 1u);
  ASSERT_EQ(second.changes.size(), 1u);
  EXPECT_EQ(first.changes[0].before, second.changes[0].before);
  EXPECT_EQ(first.changes[0].after_std, second.changes[0].after_std);
  EXPECT_EQ(first.changes[0].p_value, second.changes[0].p_value);
}

TEST(ChangeSearch, LeavesOutWhatIsNotKnown) {
  std::vector<DiveEstimate> estimates = QuietDives(5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (DiveEstimate& estimate : estimates) {
    if (estimate.dof == Dof::kYaw && estimate.dive >= 4) estimate.value(kBuoyancy) = nan;
    if (estimate.dof == Dof::kSurge) {  // stuck at its bound
      estimate.value(kLinearDamping) = 0.0;
    }
  }
  At(7, Dof::kSurge, &estimates).covariance.col(kInertia).setConstant(nan);
  At(7, Dof::kSurge, &estimates).covariance.row(kInertia).setConstant(nan);
  const ChangeSearch search = FindChanges(estimates, 30, {});
  EXPECT_TRUE(search.changes.empty());
  ASSERT_EQ(search.scatter.size(), 11u);  // without the buoyancy in yaw
  EXPECT_EQ(search.scatter[0].num_dives, 29);
  EXPECT_TRUE(FindChanges({}, 0, {}).scatter.empty());
}

}  // namespace
}  // namespace fathom
