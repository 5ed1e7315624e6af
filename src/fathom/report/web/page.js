"use strict";
// Draws the charts over time. The data stand in the element #data: a list of panels for each section,
// written by time_chart_json.cc.

// Every panel that is drawn: {panel, curves, legend, plots, group}.
const drawn = [];

(() => {
  const errors = [];
  window.addEventListener("error", (event) => errors.push(event.message));

  const WIDTHS = {measured: 2.5, response: 1.6, residual: 1.2};  // [px]
  const HEIGHTS = {response: 300, residual: 170, lone: 190};  // [px]
  const LOW_HEIGHTS = {response: 180, residual: 150, lone: 150};

  const drawPanel = (group, panel, place) => {
    if (!panel.time.length) {
      place.append(element("p", "hint", "No data."));
      return null;
    }
    const curves = [];
    if (panel.measured) curves.push({...panel.measured, width: WIDTHS.measured, drawn: []});
    for (const response of panel.responses) curves.push({...response, width: WIDTHS.response, drawn: []});
    if (panel.has_residuals) {
      const measured = panel.measured.values;
      for (const curve of curves.slice(1)) {
        curve.residual = curve.values.map(
          (value, i) => (value == null || measured[i] == null ? null : measured[i] - value));
      }
    }

    // Faded curves lie behind the full ones.
    const isResponse = (curve) => curve !== curves[0] || !panel.measured;
    const depth = (curve) => (isResponse(curve) && !curve.is_faded ? 1 : 0);
    const stacked = [...curves].sort((one, other) => depth(one) - depth(other));
    const responses = stacked.filter(isResponse);

    const legend = makeLegend(group, panel, curves);
    const frame = element("div", "plots");
    place.append(legend, frame);
    const plots = [];
    const heights = panel.is_low ? LOW_HEIGHTS : HEIGHTS;
    const isSmall = !panel.measured && curves.length === 1;
    plots.push(makePlot(group, panel, frame, {
      label: withUnit(panel.quantity, panel.unit),
      series: stacked.map((curve) => ({curve, values: curve.values, low: curve.low, high: curve.high, width: curve.width})),
      height: isSmall ? heights.lone : heights.response, hasTimeLabel: !panel.has_residuals,
    }));
    let edge = 0;
    for (const curve of stacked) if (curve.low) curve.edges = [[plots[0], ++edge], [plots[0], ++edge]];
    stacked.forEach((curve, i) => curve.drawn.push([plots[0], edge + i + 1, curve.width]));
    if (panel.has_residuals) {
      plots.push(makePlot(group, panel, frame, {
        label: withUnit("residual", panel.unit),
        series: responses.map((curve) => ({curve, values: curve.residual, width: WIDTHS.residual})),
        height: heights.residual, hasTimeLabel: true,
      }));
      responses.forEach((curve, i) => curve.drawn.push([plots[1], i + 1, WIDTHS.residual]));
    }
    for (const plot of plots) {
      plot.hooks.setCursor = [(self) => legend.update(self.cursor.left >= 0 ? self.cursor.idx : null)];
    }
    for (const plot of plots) listenToFingers(plot, group);
    listenToKeys(frame, group, `${panel.quantity} over time`);
    frame.append(saveButton(`${panel.quantity} over time`, () => columnsOf(panel)));
    return {panel, curves, legend, plots};
  };

  const sections = JSON.parse(document.getElementById("data").textContent);
  const groups = sections.map((panels, index) => linkedGroup(`section-${index}`, panels));
  for (const place of document.querySelectorAll(".chart")) {
    const group = groups[place.dataset.section];
    const one = drawPanel(group, sections[place.dataset.section][place.dataset.panel], place);
    if (!one) continue;
    if (!drawn.some((other) => other.group === group)) {
      if (group.cuts.length) {
        place.append(element("p", "hint", "Silences are cut out at the marks //; the times at the axis are true."));
      }
      place.append(element("p", "hint on-screen",
        "Drag to zoom, double-click to reset; fingers: pinch and drag; keys: + − zoom, ← → move, 0 resets. " +
        "A click on a name hides its curve or brings a pale one out."));
    }
    drawn.push({...one, group});
  }

  for (const figure of document.querySelectorAll(".scatter[data-columns]")) {
    const columns = JSON.parse(figure.dataset.columns);
    figure.append(saveButton(`${columns[1].name} over ${columns[0].name}`, () => columns));
  }

  // Paper is narrower than most windows.
  const PAPER_WIDTH = 660;  // [px]
  const fit = (widthOf) => {
    for (const {plots} of drawn) {
      for (const plot of plots) plot.setSize({width: widthOf(plot), height: plot.height});
    }
  };
  const recolor = () => {
    for (const swatch of document.querySelectorAll(".swatch")) swatch.style.background = shown(swatch.dataset.color);
    for (const {plots} of drawn) for (const plot of plots) plot.redraw(false, true);
  };
  // A table that is wider than its place becomes blocks.
  const fitTables = () => {
    for (const table of document.querySelectorAll(".table")) {
      table.classList.remove("blocks");
      table.classList.toggle("blocks", table.scrollWidth > table.clientWidth);
    }
  };
  fitTables();
  window.addEventListener("resize", fitTables);
  for (const fold of document.querySelectorAll("details")) fold.addEventListener("toggle", fitTables);
  const print = (isPaper) => {
    document.documentElement.classList.toggle("on-paper", isPaper);
    fit((plot) => (isPaper ? PAPER_WIDTH : plot.root.parentElement.clientWidth));
    fitTables();
    recolor();
  };
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolor);
  window.addEventListener("beforeprint", () => print(true));
  window.addEventListener("afterprint", () => print(false));

  if (location.hash === "#selftest") testCharts(drawn, errors).catch((error) => {
    const report = element("pre", "", `failed=${error}`);
    report.id = "selftest";
    document.body.append(report);
  });
  reloadWhileItGrows(groups);
  // "#zoom=20,40" opens the page with every chart zoomed to these times.
  const zoom = /^#zoom=([-0-9.]+),([-0-9.]+)$/.exec(location.hash);
  if (zoom) for (const group of groups) group.zoom(placeOf(group.cuts, Number(zoom[1])), placeOf(group.cuts, Number(zoom[2])));
})();
