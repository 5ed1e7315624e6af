// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/archive_page.h"

#include "fathom/archive/report/archive_sentences.h"
#include "fathom/archive/report/coupled_models_html.h"
#include "fathom/archive/report/dive_summary.h"
#include "fathom/archive/report/dives_json.h"
#include "fathom/archive/report/lost_logs_html.h"
#include "fathom/archive/report/parameter_charts_json.h"
#include "fathom/archive/report/web/assets.h"
#include "fathom/report/html_text.h"
#include "fathom/report/page_frame.h"
#include "fathom/report/page_origin.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// The sections behind the sentences; scripts fill the empty places.
constexpr std::string_view kSections = R"(<section id="parameters">
<h2>Parameters over the dives</h2>
<p class="hint">A dot is the joint fit of all logs of a dive, its bar the 95 % interval. Point at a dot, or use the arrow keys, to read it.</p>
<p class="marks" aria-hidden="true"><span class="mark-dot">dive</span><span class="mark-outlier">outlier</span><span class="mark-change">change</span><span class="mark-arrow">outside of the chart</span><span class="mark-missing">no usable fit</span></p>
<div id="parameter-charts"></div>
</section>
<section id="effects">
<h2>Effects by dive</h2>
<p class="hint">How many logs of a dive named an effect as a cause. A log without a diagnosis says nothing of faults; it is counted as not diagnosed.</p>
<div id="effect-matrices"></div>
</section>
<section id="dives">
<h2>Dives, worst first</h2>
<p class="hint">Worst are dives with the most logs without a model, then with the most red findings, then with the largest held-out NMAE. NMAE is the mean absolute error of the simulated speed over the mean absolute speed; the figure is the worst DOF's. For the prediction NMAE the model of the previous dive simulates this one.</p>
<div id="dive-table"></div>
</section>
<section id="comparison">
<h2>Two dives side by side</h2>
<div id="dive-comparison"></div>
</section>
)";

std::string HeaderHtml(const ArchiveReport& report, bool has_coupled) {
  std::string html = fmt::format("<header>\n<h1>{}</h1>\n", HtmlText("Archive " + report.archive));
  for (const std::string& sentence : ChangeSentences(report.tables)) {
    html += fmt::format("<p class=\"lead change\">{}</p>\n", HtmlText(sentence));
  }
  html += fmt::format("<p class=\"lead logs\">{}</p>\n", HtmlText(LogsSentence(report)));
  for (const std::string& sentence :
       {DivesWithoutFitSentence(report.tables), NearlyLogsSentence(report.nearly_logs)}) {
    if (sentence.empty()) continue;
    html += fmt::format("<p class=\"lead\">{}</p>\n", HtmlText(sentence));
  }
  // The archive stands for its logs.
  PageOrigin origin = report.origin;
  origin.logs = {{"Archive " + report.archive, "", ""}};
  html += OriginHtml(origin);
  return html +
         "<nav><a href=\"#parameters\">Parameters</a><a href=\"#effects\">Effects</a>"
         "<a href=\"#dives\">Dives</a><a href=\"#comparison\">Two dives</a>" +
         (has_coupled ? "<a href=\"#coupled\">Coupled models</a>" : "") +
         "<a href=\"#lost\">Logs without a model</a></nav>\n</header>\n";
}

// The scripts share their names and nothing else does.
std::string Script() {
  std::string script = "\"use strict\";\n(() => {\n";
  for (const std::string_view part : {web::dom_js,
                                      web::parameter_charts_js,
                                      web::effect_matrix_js,
                                      web::dive_table_js,
                                      web::dive_comparison_js,
                                      web::archive_selftest_js,
                                      web::archive_js}) {
    script += part;
  }
  return script + "})();\n";
}

}  // namespace

std::string RenderArchivePage(const ArchiveReport& report) {
  const std::vector<DiveSummary> summaries = SummariesOf(report);
  std::vector<std::string> dives;
  dives.reserve(summaries.size());
  for (const DiveSummary& summary : summaries) dives.push_back(summary.dive);

  const std::string coupled = CoupledModelsHtml(report);
  FramedPage page;
  page.title = "Archive " + report.archive;
  page.style = fmt::format("{}\n{}", PageStyle(), web::archive_css);
  page.body = HeaderHtml(report, !coupled.empty()) + "<main>\n" +
              "<noscript><p class=\"warning\">Charts, the table of dives and the comparison need "
              "JavaScript; the sentences above and the logs without a model are here."
              "</p></noscript>\n" +
              std::string(kSections) + coupled +
              "<section id=\"lost\">\n<h2>Logs without a model</h2>\n" +
              LostLogsHtml(report.tables.logs) + "</section>\n</main>\n";
  page.data = fmt::format(R"({{"parameters":{},"archive":{}}})",
                          ParameterChartsJson(report, dives),
                          DivesJson(report, summaries));
  page.scripts = {Script()};
  return FramedHtml(page);
}

}  // namespace fathom
