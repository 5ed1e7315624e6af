"use strict";
// Uses the first panel as a reader would and writes what happened into the page; for the tests.
const testCharts = async (drawn, errors) => {
  const frame = () => new Promise((done) => setTimeout(done, 60));
  const mouse = (target, type, plot, left, top) => {
    const box = plot.over.getBoundingClientRect();
    target.dispatchEvent(new MouseEvent(type, {bubbles: true, cancelable: true, view: window, button: 0,
      movementX: 1, clientX: box.left + left, clientY: box.top + top}));
  };
  const isDrawn = (plot) => {
    const {width, height} = plot.ctx.canvas;
    const pixels = plot.ctx.getImageData(0, 0, width, height).data;
    return pixels.some((value) => value !== 0);
  };
  // Pixels that have about the colour of the curve.
  const inkOf = (plot, color) => {
    const wanted = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
    const {left, top, width, height} = plot.bbox;
    const pixels = plot.ctx.getImageData(left, top, width, height).data;
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (wanted.every((level, k) => Math.abs(pixels[i + k] - level) < 12)) ++count;
    }
    return count;
  };
  const findings = {};
  await frame();
  const plots = drawn.flatMap((one) => one.plots);
  findings.charts = plots.length;
  findings.charts_drawn = plots.filter(isDrawn).length;
  findings.resources_loaded = performance.getEntriesByType("resource").length;

  const {curves, legend, plots: [response, residual], group} = drawn[0];
  const curve = curves[curves.length - 1];
  const button = legend.querySelectorAll("button")[curves.length - 1];
  findings.ink_before = inkOf(response, curve.color);
  findings.residual_ink_before = residual ? inkOf(residual, curve.color) : 0;
  button.click();
  await frame();
  findings.ink_hidden = inkOf(response, curve.color);
  findings.residual_ink_hidden = residual ? inkOf(residual, curve.color) : 0;
  findings.pressed_hidden = button.getAttribute("aria-pressed");
  button.click();
  await frame();
  findings.ink_after = inkOf(response, curve.color);

  // Of every curve in its own colour: none is covered or tinted.
  findings.inks = drawn.flatMap((one) => one.curves.map(({color}) => inkOf(one.plots[0], color))).join(" ");

  const width = response.over.clientWidth;
  mouse(response.over, "mouseenter", response, width / 2, 50);
  mouse(response.over, "mousemove", response, width / 2, 50);
  await frame();
  findings.read_out = legend.textContent;
  findings.charts_with_cursor = group.plots.filter((plot) => plot.cursor.left > 0).length;

  const shownTimes = () => group.plots.map(({scales: {x}}) => `${x.min.toFixed(3)}..${x.max.toFixed(3)}`).join(" ");
  const drag = async () => {
    mouse(response.over, "mousedown", response, width / 4, 50);
    mouse(response.over, "mousemove", response, width / 2, 50);
    await frame();
    mouse(document, "mouseup", response, width / 2, 50);
    await frame();
  };
  const reset = legend.querySelector(".reset");
  await drag();
  findings.zoom = shownTimes();
  findings.reset_shown = !reset.hidden;
  mouse(response.over, "dblclick", response, width / 2, 50);
  await frame();
  findings.zoom_after_double_click = shownTimes();
  await drag();
  findings.zoom_again = shownTimes();
  reset.click();
  await frame();
  findings.zoom_after_reset = shownTimes();
  findings.reset_hidden = reset.hidden;
  // One chart zoomed from within: the others follow.
  group.plots[group.plots.length - 1].setScale("x", {min: group.first, max: group.first + 1});
  await frame();
  findings.zoom_from_last = shownTimes();
  findings.errors = errors.length;
  const text = Object.entries(findings).map(([name, value]) => `${name}=${value}`).join("\n");
  const report = element("pre", "", `${text}\nerror_texts=${errors.join("; ")}\n`);
  report.id = "selftest";
  document.body.append(report);
};
