// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/page_origin.h"
#include "fathom/report/panel.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

struct Fact {
  std::string name;
  std::string value;
};

// What is closed until a reader asks for it; on paper only if it stands open.
struct PageFold {
  std::string summary;            // the words to click on
  std::vector<std::string> text;  // paragraphs
  std::vector<CurvePanel> curves = {};
  std::vector<Table> tables = {};
};

// One subject of a page, for example one DOF. Whatever is empty is left out. The time axes of all
// panels of a section are linked: they zoom together and share the cursor.
struct PageSection {
  std::string heading;
  std::vector<std::string> text;  // paragraphs
  std::vector<std::string> warnings;
  std::vector<TimePanel> time_panels;
  std::vector<ParameterPanel> parameter_panels;
  std::vector<Table> tables;
  std::vector<PlanPanel> plan_panels = {};        // above the charts over time
  std::vector<CurvePanel> curve_panels = {};      // below the charts over time
  std::vector<PageFold> folds = {};               // below these
  std::vector<ScatterPanel> scatter_panels = {};  // below these
  std::vector<std::string> notes = {};            // routine, on the data; folded away below all
};

struct Page {
  std::string title;
  std::string subtitle;
  std::vector<std::string> lead;  // paragraphs; the first one says what came out, in one sentence
  std::vector<Fact> facts;
  std::vector<std::string> warnings;
  std::vector<PageSection> sections;
  std::string footer;      // how to read it
  PageOrigin origin = {};  // in the header

  // Of a page that is written anew while its data grow: it loads itself again behind so long [s],
  // unless a reader zooms. 0: never.
  double reload_after = 0.0;
};

// One HTML file with everything in it: no network, no other file. All texts are plain text and are
// escaped; series of more than 20 000 stamps are thinned for display (docs/report.md) and say so.
std::string RenderPage(const Page& page);

}  // namespace fathom
