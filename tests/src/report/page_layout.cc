// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "page_layout.h"

#include "fathom/base/files/output_file.h"

#include <filesystem>
#include <string_view>

#include "headless_browser.h"
#include "test_folder.h"
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
  parent.postMessage({look: LOOK, text}, "*");
});
</script>)";

// A page of frames, and what they post: the findings of each under its number.
constexpr std::string_view kFrames = R"(<!doctype html><body><script>
addEventListener("message", ({data: {look, text}}) => {
  const report = document.createElement("pre");
  report.id = `look_${look}`;
  report.textContent = text;
  document.body.append(report);
});
</script>FRAMES</body>)";

void ReplaceAll(std::string_view from, std::string_view to, std::string* text) {
  for (std::size_t at = 0; (at = text->find(from, at)) != std::string::npos; at += to.size()) {
    text->replace(at, from.size(), to);
  }
}

// The page as it stands in a look, with the script that posts what is wrong with it.
std::string PageIn(const PageLook& look, std::size_t number, const std::string& html) {
  std::string page = html;
  if (look.is_printed) ReplaceAll("@media print", "@media all", &page);
  if (look.is_dark) ReplaceAll("(prefers-color-scheme: dark)", "(min-width: 1px)", &page);
  std::string script(kLayoutScript);
  ReplaceAll("IS_PRINTED", look.is_printed ? "true" : "false", &script);
  ReplaceAll("LOOK", std::to_string(number), &script);
  ReplaceAll("<head>", fmt::format("<head>{}", kErrorScript), &page);
  page.insert(page.rfind("</body>"), script);
  return page;
}

}  // namespace

std::vector<std::map<std::string, std::string>> FaultsOf(const std::string& html,
                                                         const std::vector<PageLook>& looks) {
  const std::filesystem::path folder = TestFolder() / "looks";
  std::string frames;
  for (std::size_t k = 0; k < looks.size(); ++k) {
    const std::filesystem::path file = folder / fmt::format("{}.html", k);
    WriteFile(file, PageIn(looks[k], k, html));
    frames += fmt::format(
        R"(<iframe width="{}" height="1000" style="border:0" src="file://{}"></iframe>)",
        looks[k].width,
        file.string());
  }
  std::string page(kFrames);
  ReplaceAll("FRAMES", frames, &page);
  const std::string dom = DomOf(page, {.hash = ""});
  std::filesystem::remove_all(folder);

  std::vector<std::map<std::string, std::string>> faults;
  for (std::size_t k = 0; k < looks.size(); ++k) {
    faults.push_back(FindingsIn(dom, fmt::format("look_{}", k)));
    if (faults.back().empty()) faults.back()["errors"] = "the browser did not load the page";
  }
  return faults;
}

}  // namespace fathom
