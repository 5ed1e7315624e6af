// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/structure_text.h"

#include "fathom/comparison/structure_file.h"
#include "fathom/comparison/structure_page.h"

#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

StructureRow HandmadeStructure(std::string name, double unseen) {
  StructureRow row;
  row.name = std::move(name);
  row.is_usable = true;
  row.num_numbers = 8;
  row.train_nmae.fill(0.5 * unseen);
  row.held_out_nmae.fill(std::numeric_limits<double>::quiet_NaN());
  row.unseen_nmae.fill(unseen);
  row.seconds = 1.25;
  return row;
}

// What auto took, by so much nearer than models of one DOF, and `full`, by so much nearer still.
StructureComparison Handmade(UnseenGain taken, UnseenGain full) {
  StructureComparison comparison;
  comparison.log_name = "tank_07";
  comparison.dofs = {Dof::kSurge, Dof::kYaw};
  comparison.window = 20.0;
  comparison.rows = {HandmadeStructure("adaptive", 0.4),
                     HandmadeStructure("best", 0.2),
                     HandmadeStructure("full", 0.09),
                     HandmadeStructure("auto", 0.1)};
  comparison.rows[0].is_of_one_dof = comparison.rows[1].is_of_one_dof = true;
  comparison.rows[0].is_usable = false;
  comparison.rows[0].message = "surge: diverged";
  comparison.rows[1].of_families = {"least_squares", "output_error"};
  comparison.rows[2].gain = UnseenGain{0.5, 9.0};
  comparison.rows[2].gain_over_taken = full;
  comparison.rows[3].chosen = "coriolis";
  comparison.rows[3].gain = taken;
  return comparison;
}

TEST(StructureSentence, SaysThatTheCouplingBeatsModelsOfOneDof) {
  EXPECT_EQ(StructureSentence(Handmade({0.123, 4.25}, {0.01, 0.3})),
            "auto takes coriolis, 8 numbers. Over data that were not fitted its runs are nearer "
            "than those of the best models of one DOF each (surge least squares, yaw output "
            "error), by 12.3 % or 4.2 standard errors.");
}

TEST(StructureSentence, SaysWhereModelsOfOneDofAreToBeTaken) {
  EXPECT_THAT(StructureSentence(Handmade({-0.05, -2.0}, {0.01, 0.3})),
              HasSubstr("farther off than those of the best models of one DOF each (surge least "
                        "squares, yaw output error), by 5.0 % or 2.0 standard errors: take those"));
}

TEST(StructureSentence, CallsNothingALeadThatMayBeChance) {
  const std::string sentence = StructureSentence(Handmade({0.05, 1.6}, {0.05, 1.6}));
  EXPECT_THAT(sentence, HasSubstr("not clearly nearer"));
  EXPECT_THAT(sentence, HasSubstr("+5.0 % or +1.6 standard errors"));
  EXPECT_THAT(sentence, Not(HasSubstr("Nearer still")));
}

TEST(StructureSentence, NamesWhatIsNearerThanWhatAutoTook) {
  EXPECT_THAT(StructureSentence(Handmade({0.5, 9.0}, {0.1, 2.5})),
              HasSubstr("Nearer still: full by 10.0 % or 2.5 standard errors."));
}

TEST(StructureSentence, SaysThatAutoHasNoUsableModel) {
  StructureComparison comparison = Handmade({0.5, 9.0}, {0.1, 2.5});
  comparison.rows[3].is_usable = false;
  EXPECT_EQ(comparison.Taken(), nullptr);
  EXPECT_THAT(StructureSentence(comparison), HasSubstr("usable model"));
}

TEST(StructureSentence, SaysThatThereAreNoModelsOfOneDof) {
  StructureComparison comparison = Handmade({0.5, 9.0}, {0.01, 0.3});
  comparison.rows[1].is_usable = false;
  comparison.rows[3].gain.reset();
  EXPECT_THAT(StructureSentence(comparison), HasSubstr("no usable models of one DOF"));
}

TEST(StructureTables, MarkWhatAutoTookAndWhatIsNotUsable) {
  const std::string text = FormatTable(UnseenTable(Handmade({0.5, 9.0}, {0.1, 2.5})));
  EXPECT_THAT(text, HasSubstr("! one DOF each, adaptive"));
  EXPECT_THAT(text, HasSubstr("  one DOF each, best"));
  EXPECT_THAT(text, HasSubstr("* auto: coriolis"));
  EXPECT_THAT(text, HasSubstr("50.0 %"));
  EXPECT_THAT(CommentsOn(Handmade({0.5, 9.0}, {0.1, 2.5}))[0],
              HasSubstr("! one DOF each, adaptive: surge: diverged"));
}

TEST(StructureFile, ARowHoldsWhatTheFormatPromises) {
  const Json json = Json::parse(FormatStructures(Handmade({0.5, 9.0}, {0.1, 2.5})));
  EXPECT_EQ(json["schema"], "fathom-structures-1");
  EXPECT_EQ(json["log"], "tank_07");
  EXPECT_EQ(json["dofs"], Json({"surge", "yaw"}));
  EXPECT_EQ(json["window"], 20.0);
  ASSERT_EQ(json["rows"].size(), 4u);
  const Json best = json["rows"][1], taken = json["rows"][3];
  EXPECT_EQ(best["model"], "one_dof_each");
  EXPECT_EQ(best["family"], "best");
  EXPECT_EQ(best["families"], Json({"least_squares", "output_error"}));
  EXPECT_EQ(best["nearer_than_one_dof_each"], Json());
  EXPECT_EQ(taken["model"], "coupled");
  EXPECT_EQ(taken["structure"], "auto");
  EXPECT_EQ(taken["chosen"], "coriolis");
  EXPECT_EQ(taken["numbers"], 8);
  EXPECT_EQ(taken["nmae"]["yaw"], 0.05);
  EXPECT_EQ(taken["unseen_nmae"]["surge"], 0.1);
  EXPECT_EQ(taken["heldout_nmae"]["surge"], Json());
  EXPECT_EQ(taken["nearer_than_one_dof_each"]["share"], 0.5);
  EXPECT_EQ(taken["nearer_than_one_dof_each"]["standard_errors"], 9.0);
  EXPECT_EQ(taken["seconds"], 1.25);
  EXPECT_EQ(taken["usable"], true);
  EXPECT_EQ(taken["taken"], true);
  EXPECT_EQ(json["rows"][0]["usable"], false);
  EXPECT_EQ(json["rows"][0]["message"], "surge: diverged");
}

TEST(StructurePage, SaysFirstWhatCameOut) {
  const StructureComparison comparison = Handmade({0.5, 9.0}, {0.1, 2.5});
  const Page page = StructurePage(comparison);
  ASSERT_FALSE(page.lead.empty());
  EXPECT_EQ(page.lead[0], StructureSentence(comparison));
  EXPECT_EQ(page.sections.size(), 3u);  // the models, surge and yaw
}

}  // namespace
}  // namespace fathom
