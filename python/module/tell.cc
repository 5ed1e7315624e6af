// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/tell.h"

#include "fathom/base/number.h"
#include "fathom/base/utc_time.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/report/html_text.h"
#include "fathom/report/table_html.h"

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "module/python_words.h"
#include <fmt/format.h>
#include <pybind11/pybind11.h>

namespace fathom {

namespace py = pybind11;

void WarnOf(const std::vector<Finding>& findings) {
  const py::object category = py::module_::import("fathom._fathom").attr("FindingWarning");
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::kWarning) continue;
    if (PyErr_WarnEx(category.ptr(), finding.sentence.c_str(), 1) != 0) {
      throw py::error_already_set();
    }
  }
}

PageOrigin OriginInPython(const std::vector<Log>& logs) {
  double now = std::floor(
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count());
  // As the tools have it, so that the same run writes the same bytes.
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    now = ParseFiniteNumber(fixed).value_or(now);
  }
  PageOrigin origin = {"Fathom " FATHOM_VERSION, FormatUtc(now), "import fathom", {}};
  for (const Log& log : logs) origin.logs.push_back({log.name, "", FingerprintOf(log)});
  return origin;
}

std::string FrameOf(const std::string& page) {
  return fmt::format(
      R"(<iframe style="width:100%;height:40em;border:1px solid #ccc" srcdoc="{}"></iframe>)",
      HtmlText(page));
}

std::string NotebookTable(const Table& table) { return TableHtml(table); }

std::string NotebookText(const std::string& text) { return "<pre>" + HtmlText(text) + "</pre>\n"; }

std::string NoteLines(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : InPythonWords(notes)) text += "note: " + note + "\n";
  return text;
}

}  // namespace fathom
