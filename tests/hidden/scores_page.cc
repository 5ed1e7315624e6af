// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scores_page.h"

#include <cmath>

#include "binomial.h"
#include "confusion_matrix.h"
#include "score_board.h"
#include <fmt/format.h>

namespace fathom::hidden {
namespace {

std::string Share(int count, int total) {
  if (total == 0) return "no logs";
  const Interval interval = ClopperPearson(count, total);
  return fmt::format("{} of {} = {:.1f} % ({:.1f}-{:.1f} %)",
                     count,
                     total,
                     100.0 * count / total,
                     100.0 * interval.low,
                     100.0 * interval.high);
}

std::string Share(const Coverage& coverage) {
  return Share(coverage.inside, coverage.total) +
         (coverage.missing > 0 ? fmt::format(", {} without an interval", coverage.missing) : "");
}

struct Measure {
  std::string what, value, bar;
};

std::vector<Measure> Measures(const ScoreBoard& board) {
  const Tally& one = board.separable_one;
  const Tally& two = board.separable_two;
  const int separable = one.logs + two.logs;
  return {
      {"clear and separable: named, alone or in a group",
       Share(one.Named() + two.Named(), separable),
       "at least 90 %, aim 97 %"},
      {"clear and separable: named alone",
       Share(one.Of(Outcome::kAlone) + two.Of(Outcome::kAlone), separable),
       "at least 80 %"},
      {"- of them one effect: named", Share(one.Named(), one.logs), ""},
      {"- of them one effect: alone", Share(one.Of(Outcome::kAlone), one.logs), ""},
      {"- of them two effects: named", Share(two.Named(), two.logs), ""},
      {"- of them two effects: alone", Share(two.Of(Outcome::kAlone), two.logs), ""},
      {"clear and separable: a wrong certain cause",
       Share(one.Of(Outcome::kWrong) + two.Of(Outcome::kWrong), separable),
       ""},
      {"nothing hidden: any cause named", Share(board.false_causes, board.nothing), "at most 5 %"},
      {"nothing hidden: a certain cause", Share(board.false_certain_causes, board.nothing), ""},
      {"nothing hidden: not `consistent`", Share(board.not_consistent, board.nothing), ""},
      {"outside the catalogue: a certain cause",
       Share(board.unlisted_certain, board.unlisted.logs),
       "at most 20 %"},
      {"- of the clear ones", Share(board.unlisted_clear_certain, board.unlisted_clear), ""},
      {"- clear, but `consistent`", Share(board.unlisted_clear_unseen, board.unlisted_clear), ""},
      {"held-out gain reached / oracle's, median",
       fmt::format("{:.3f} over {} logs", board.MedianGainRatio(), board.gain_ratios.size()),
       "at least 0.90"},
      {"95 % intervals of effect parameters hold the truth",
       Share(board.effect_parameters),
       "92-98 %"},
      {"95 % intervals of model parameters hold the truth",
       Share(board.model_parameters),
       "92-98 %"},
      {"- nothing hidden, nothing named", Share(board.null_model_parameters), "92-98 %"},
  };
}

std::string EffectTable(const ScoreBoard& board) {
  std::string text =
      "| hidden | logs | clear | separable | alone | group | abstained | group without it | wrong "
      "| "
      "effect's intervals | model's intervals |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  const auto coverage = [](const Coverage& c) { return fmt::format("{}/{}", c.inside, c.total); };
  for (const EffectRow& row : board.effects) {
    const Tally& tally = row.separable_tally;
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                        row.effect,
                        row.all.logs,
                        row.clear,
                        row.separable,
                        tally.Of(Outcome::kAlone),
                        tally.Of(Outcome::kGroup),
                        tally.Of(Outcome::kAbstained),
                        tally.Of(Outcome::kGroupWithout) + tally.Of(Outcome::kPart),
                        tally.Of(Outcome::kWrong),
                        coverage(row.effect_parameters),
                        coverage(row.model_parameters));
  }
  return text;
}

std::string Table(const std::vector<LogScore>& scores, HiddenClass hidden) {
  const bool has_rivals = hidden == HiddenClass::kTwoEffects;
  std::string text = has_rivals ? "| hidden | oracle | outcome | verdict | named |\n"
                                : "| hidden | oracle | verdict | named |\n";
  text += has_rivals ? "| --- | --- | --- | --- | --- |\n" : "| --- | --- | --- | --- |\n";
  for (const LogScore& score : scores) {
    if (score.hidden != hidden) continue;
    const OracleAnswer& oracle = score.oracle;
    std::string effects;
    for (const std::string& effect : score.effects) {
      effects += (effects.empty() ? "" : " + ") + effect;
    }
    const std::string seen = !oracle.IsClear()                     ? "not clear"
                             : !has_rivals || oracle.IsSeparable() ? "clear"
                                                                   : "like " + oracle.rival;
    text += fmt::format("| {} | {} |{} {} | {} |\n",
                        effects,
                        seen,
                        has_rivals ? fmt::format(" {} |", Name(score.outcome)) : "",
                        Name(score.verdict),
                        score.named);
  }
  return text;
}

}  // namespace

std::string Summary(const std::vector<LogScore>& scores) {
  std::string text;
  for (const Measure& measure : Measures(BoardOf(scores))) {
    text += fmt::format("{:<52} {:<36} {}\n", measure.what, measure.value, measure.bar);
  }
  return text;
}

std::string Line(const LogScore& score) {
  const OracleAnswer& oracle = score.oracle;
  std::string seen;
  if (score.hidden != HiddenClass::kNothing) {
    seen = !oracle.IsClear() ? fmt::format("not clear ({:.0f})", oracle.baseline_delta_bic)
           : score.hidden == HiddenClass::kUnlisted || oracle.IsSeparable()
               ? fmt::format("clear ({:.0f}; {:.0f} {})",
                             oracle.baseline_delta_bic,
                             oracle.rival_delta_bic,
                             oracle.rival)
               : fmt::format("like {} ({:.0f}; {:.0f})",
                             oracle.rival,
                             oracle.baseline_delta_bic,
                             oracle.rival_delta_bic);
  }
  const std::string outcome =
      score.hidden == HiddenClass::kNothing || score.hidden == HiddenClass::kUnlisted
          ? ""
          : std::string(Name(score.outcome));
  const std::string gains =
      std::isfinite(score.gain) ? fmt::format("{:.3f}/{:.3f}", score.gain, score.oracle_gain) : "";
  return fmt::format("{:<28} {:<46} {:<12} {:<16} {:<40} gain {:<12} {:.1f} s | {}",
                     score.name,
                     seen,
                     Name(score.verdict),
                     outcome,
                     score.named.empty() ? "-" : score.named,
                     gains,
                     score.seconds,
                     score.setup);
}

std::string ScoresPage(const std::vector<LogScore>& scores, const std::string& command) {
  const ScoreBoard board = BoardOf(scores);
  std::string page = fmt::format(
      "# How often the diagnosis is right\n\n"
      "The diagnosis is tested on {} synthetic logs. A seed that the diagnosis does not see draws "
      "vehicle,\ninputs, noise, drop-outs, outliers, turbulence, other DOFs that move, and what is "
      "hidden. Nothing is\nhidden in {} logs, one effect in {}, two in {}, an effect outside the "
      "catalogue in {}. This page\nwas written by\n\n    {}\n\n"
      "An oracle knows what is hidden and the noise that was drawn. It fits the true structure, "
      "the\nbaseline and every rival. The rivals are every other effect with every partner that "
      "moves; for two\neffects, the sets with one replaced and each alone. An effect is *clear* if "
      "the true structure beats\nthe baseline by a BIC of 30, and *separable* if it beats every "
      "rival by 10. Its signature is drawn\nbetween 6 and 60 standard deviations, so sizes range "
      "from just detectable to large. A cause is named\n*alone* if it is the only answer given, "
      "and in a *group* if it is among the alternatives. Intervals\nin brackets are those of "
      "Clopper and Pearson, 95 %. Code: tests/hidden.\n\n",
      scores.size(),
      board.nothing,
      board.all_one.logs,
      board.all_two.logs,
      board.unlisted.logs,
      command);
  page += "| | figure | bar |\n| --- | --- | --- |\n";
  for (const Measure& measure : Measures(board)) {
    page += fmt::format("| {} | {} | {} |\n", measure.what, measure.value, measure.bar);
  }
  page +=
      "\nAll gains are those of the NMAE of the velocity on the held-out data, simulated from the "
      "command\nalone and started where the simulation fits them best, over clear logs on which "
      "the oracle gains at\nleast 2 %. Intervals are counted if exactly what is hidden is named "
      "alone.\n\n"
      "## One effect\n\nThe table counts the outcomes of the logs that are clear and "
      "separable.\n\n" +
      EffectTable(board) +
      "\n## Confusion matrix\n\nThe matrix is for logs with one effect or nothing hidden, clear "
      "and separable. Rows are what is\nhidden. Columns are what is named alone, by the letter of "
      "its row; then a group that holds what is\nhidden, a group or part that does not, and no "
      "cause. Several certain causes count in the column of\nthe first that is wrong.\n\n" +
      ConfusionMatrix(scores, true) +
      "\nOn the following logs the oracle cannot separate the effect, or hardly sees it. A "
      "group or no cause\nis the right answer there:\n\n" +
      ConfusionMatrix(scores, false) + "\n## Two effects\n\n" +
      Table(scores, HiddenClass::kTwoEffects) + "\n## Outside the catalogue\n\n" +
      "A certain cause is `explained` without alternatives.\n\n" +
      Table(scores, HiddenClass::kUnlisted);
  return page;
}

}  // namespace fathom::hidden
