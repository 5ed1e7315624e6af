// Uses the page as a reader would and writes what happened into it; for the tests.
const testYourself = (readAfter, drawnAfter) => {
  const root = document.documentElement;
  const findings = {read_ms: readAfter.toFixed(1), drawn_ms: drawnAfter.toFixed(1), width: root.clientWidth};
  const all = (selector) => [...document.querySelectorAll(selector)];
  // Pixels by which something sticks out of the page, or the table of dives out of its box.
  const overflow = () => Math.max(0, ...[root, ...all("#dive-table .table")].map((box) => box.scrollWidth - box.clientWidth));
  const firstDive = () => document.querySelector(".dive-row .opener")?.textContent ?? "";
  try {
    findings.overflow = overflow();
    findings.controls_in_sight = all("input, select, .plain").filter((field) => field.offsetWidth > 0).length;
    for (const start of undrawn) start();
    findings.charts = all(".over-dives svg").length;
    findings.charts_drawn = all(".over-dives svg").filter((svg) => svg.querySelector(".dots")?.getAttribute("d")).length;
    findings.lone_rows = all(".lone tr").map((row) => row.textContent).join(" | ");
    findings.borders = all(".border").filter((path) => path.getAttribute("d")).length;
    findings.diamonds = all(".diamonds").filter((path) => path.getAttribute("d")).length;
    findings.arrows = all(".arrows").filter((path) => path.getAttribute("d")).length;
    findings.matrices = all(".matrix").length;
    findings.cells = all(".matrix .cell.cause").length;
    findings.not_diagnosed_cells = all(".matrix .cell.not-diagnosed").length;

    const chart = document.querySelector(".over-dives svg");
    chart?.dispatchEvent(new KeyboardEvent("keydown", {key: "ArrowRight", bubbles: true, cancelable: true}));
    findings.read_out = document.querySelector(".over-dives .read-out")?.textContent ?? "";

    findings.rows = all(".dive-row").length;
    findings.worst_dive = firstDive();
    findings.first_address = document.querySelector("#dive-table a")?.getAttribute("href") ?? "";
    document.querySelector(".opener")?.click();
    findings.logs_opened = all(".logs-of-dive li").map((item) => item.textContent).join(" | ");
    findings.overflow_opened = overflow();

    const sorter = all(".sorter").find((button) => button.textContent === "held-out NMAE");
    sorter.click();
    findings.largest_score = firstDive();
    findings.sorted = sorter.parentElement.getAttribute("aria-sort");
    sorter.click();
    findings.smallest_score = firstDive();

    const filter = document.querySelector("#dive-table input");
    filter.value = "crashed";
    filter.dispatchEvent(new Event("input"));
    findings.rows_crashed = all(".dive-row").length;
    filter.value = "";
    filter.dispatchEvent(new Event("input"));
    const more = all("#dive-table > button")[0];
    if (!more.hidden) more.click();
    findings.rows_all = all(".dive-row").length;
    filter.value = "crashed";  // thousands of rows would be laid out and written for nothing
    filter.dispatchEvent(new Event("input"));

    const selects = all("#dive-comparison select");
    if (selects.length) {
      findings.compared = selects.map((select) => select.selectedOptions[0].textContent).join(" | ");
      findings.differences = all(".side-by-side .large").map((row) => row.textContent).join(" | ");
      selects[1].value = selects[0].value;
      selects[1].dispatchEvent(new Event("change"));
      findings.differences_of_same = all(".side-by-side .large").length;
    }
    findings.unlabelled = all("input, select, button").filter((field) => !field.labels?.length && !field.textContent).length;
    findings.overflow_at_end = overflow();
  } catch (error) {
    findings.failed = error;
  }
  findings.resources_loaded = performance.getEntriesByType("resource").length;
  findings.errors = errors.length;
  findings.error_texts = errors.join("; ");
  const lines = Object.entries(findings).map(([name, value]) => `${name}=${value}`);
  const report = element("pre", "", `${lines.join("\n")}\n`);
  report.id = "selftest";
  document.body.append(report);
  if (window.parent !== window) window.parent.postMessage(report.textContent, "*");
};
