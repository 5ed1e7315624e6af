// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/trends/change_search.h"

#include <algorithm>
#include <cmath>

#include "drawn_archive.h"
#include "side_by_side.h"
#include <gtest/gtest.h>

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

TEST(ChangeSearch, FindsAStepAtItsDive) {
  const int num_archives = 400;
  ChangeOptions options;
  options.num_draws = 199;
  std::vector<char> is_found(num_archives), is_placed(num_archives), has_more(num_archives);
  SideBySide(num_archives, 2, [&](std::size_t i) {
    const DrawnArchive archive = TurbulentArchive();
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
    const ChangeSearch search = FindChanges(estimates, 30, options);
    for (const Change& change : search.changes) {
      const bool is_it = change.dof == dof && change.parameter == parameter;
      is_found[i] = is_found[i] || is_it;
      is_placed[i] = is_placed[i] ||
                     (is_it && change.kind == ChangeKind::kStep && std::abs(change.at - at) <= 1);
    }
    has_more[i] = search.changes.size() > 1;
  });
  const int found = std::count(is_found.begin(), is_found.end(), 1);
  const int placed = std::count(is_placed.begin(), is_placed.end(), 1);
  RecordProperty("found", found);
  RecordProperty("placed", placed);
  RecordProperty("more", static_cast<int>(std::count(has_more.begin(), has_more.end(), 1)));
  EXPECT_GE(found, 0.9 * num_archives);
  EXPECT_GE(placed, 0.8 * num_archives);
}

}  // namespace
}  // namespace fathom
