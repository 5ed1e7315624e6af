// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "page_layout.h"

#include <string_view>

#include "headless_browser.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kErrorScript = R"(<script>
window.foundErrors = [];
addEventListener("error", (event) => foundErrors.push(event.message));
console.error = (...texts) => foundErrors.push(texts.join(" "));
</script>)";

// Looks at every element, then opens what folds (not on paper) and looks again.
constexpr std::string_view kLayoutScript = R"(<script>
addEventListener("load", async () => {
  const isPrinted = IS_PRINTED;
  const wait = () => new Promise((done) => setTimeout(done, 300));
  const overflow = new Set();
  const look = (when) => {
    const page = document.documentElement;
    if (page.scrollWidth > innerWidth) overflow.add(`${when} the page: ${page.scrollWidth} of ${innerWidth} px`);
    for (const one of document.body.querySelectorAll("*")) {
      if (!one.getClientRects().length || one.closest("svg, .uplot")) continue;
      const name = `${when} ${one.tagName}.${one.className} "${one.textContent.slice(0, 30)}"`;
      const box = one.getBoundingClientRect();
      if (box.width && (box.right > innerWidth + 1 || box.left < -1)) {
        overflow.add(`${name}: from ${box.left} to ${box.right} of ${innerWidth} px`);
      }
      const canHide = getComputedStyle(one).overflowX !== "visible" || one.matches("td, th");
      if (canHide && one.clientWidth && one.scrollWidth > one.clientWidth + 1) {
        overflow.add(`${name}: shows ${one.clientWidth} of ${one.scrollWidth} px`);
      }
    }
  };
  await wait();
  if (isPrinted) dispatchEvent(new Event("beforeprint"));
  await wait();
  look("at first");
  const screen = isPrinted ? ["Drag to zoom", "Reset zoom", "hover to read", "Save as CSV"].filter((text) => document.body.innerText.includes(text)) : [];
  if (!isPrinted) {
    for (const fold of document.querySelectorAll("details")) fold.open = true;
    await wait();
    look("opened");
  }
  const unlabelled = [...document.querySelectorAll("figure, canvas")].filter((chart) =>
    !chart.matches("[aria-label], [aria-labelledby]") && !chart.querySelector("[aria-label], [aria-labelledby]"));
  const list = (texts) => [...texts].slice(0, 8).join("; ").replace(/\s+/g, " ");
  const text = `overflow=${list(overflow)}\nerrors=${list(foundErrors)}\n` +
    `unlabelled=${list(unlabelled.map((chart) => chart.className))}\nscreen=${list(screen)}\n`;
  if (parent !== window) {
    parent.postMessage(text, "*");
    return;
  }
  const report = document.createElement("pre");
  report.id = "selftest";
  report.textContent = text;
  document.body.append(report);
});
</script>)";

void ReplaceAll(std::string_view from, std::string_view to, std::string* text) {
  for (std::size_t at = 0; (at = text->find(from, at)) != std::string::npos; at += to.size()) {
    text->replace(at, from.size(), to);
  }
}

}  // namespace

std::map<std::string, std::string> FaultsOf(const std::string& html, const PageLook& look) {
  std::string page = html;
  if (look.is_printed) ReplaceAll("@media print", "@media all", &page);
  if (look.is_dark) ReplaceAll("(prefers-color-scheme: dark)", "(min-width: 1px)", &page);
  std::string script(kLayoutScript);
  ReplaceAll("IS_PRINTED", look.is_printed ? "true" : "false", &script);
  ReplaceAll("<head>", fmt::format("<head>{}", kErrorScript), &page);
  page.insert(page.rfind("</body>"), script);
  auto findings = FindingsIn(DomOf(page, {.width = look.width, .hash = ""}));
  if (findings.empty()) findings["errors"] = "the browser did not load the page";
  return findings;
}

}  // namespace fathom
