"use strict";
// Draws the charts over time. The data stand in the element #data: a list of panels for each section,
// written by time_chart_json.cc.
(() => {
  const errors = [];
  window.addEventListener("error", (event) => errors.push(event.message));

  // A colour of page.css, which has others in the dark.
  const colorOf = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  const isDark = () => window.matchMedia("(prefers-color-scheme: dark)").matches &&
    !document.documentElement.classList.contains("on-paper");
  // Of a curve: those that the dark would hide are turned round.
  const DARK_COLORS = {"#000000": "#ffffff", "#57606e": "#b4bcc8", "#0072b2": "#3d9ad6"};
  const shown = (color) => (isDark() ? DARK_COLORS[color] ?? color : color);
  const FONT = '12px system-ui, "Segoe UI", Roboto, Arial, "DejaVu Sans", sans-serif';
  const HEIGHTS = {response: 300, residual: 170, lone: 190};  // [px]
  const LOW_HEIGHTS = {response: 180, residual: 150, lone: 150};
  const AXIS_WIDTH = 72;         // [px], the same everywhere so that the time axes line up
  const FEW_STAMPS = 60;         // up to here each stamp gets a dot

  const element = (tag, kind, text = "") => {
    const made = document.createElement(tag);
    made.className = kind;
    made.textContent = text;
    return made;
  };
  const withUnit = (name, unit) => (unit ? `${name} [${unit}]` : name);

  // Writes numbers with the decimals that suit the largest of them.
  const formatterFor = (lists) => {
    let largest = 0;
    for (const list of lists) for (const value of list) largest = Math.max(largest, Math.abs(value ?? 0));
    const decimals = largest > 0 ? Math.min(Math.max(3 - Math.floor(Math.log10(largest)), 0), 9) : 0;
    return (value) => (value == null ? "–" : value.toFixed(decimals).replace("-", "−"));
  };

  // Held-out stretches, behind everything else.
  const shade = (held_out) => (plot) => {
    const {ctx, bbox} = plot;
    ctx.save();
    for (const [from, to] of held_out) {
      const left = Math.max(plot.valToPos(from, "x", true), bbox.left);
      const right = Math.min(plot.valToPos(to, "x", true), bbox.left + bbox.width);
      if (right <= left) continue;
      ctx.fillStyle = colorOf("held-out");
      ctx.fillRect(left, bbox.top, right - left, bbox.height);
    }
    ctx.restore();
  };
  const labelShades = (held_out) => (plot) => {
    const {ctx, bbox} = plot;
    const scale = uPlot.pxRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.font = FONT.replace("12px", `${12 * scale}px`);
    ctx.fillStyle = colorOf("held-out-ink");
    ctx.textBaseline = "top";
    ctx.textAlign = "left";
    for (const [from, to] of held_out) {
      const left = Math.max(plot.valToPos(from, "x", true), bbox.left);
      const right = Math.min(plot.valToPos(to, "x", true), bbox.left + bbox.width);
      if (right - left > 60 * scale) ctx.fillText("held out", left + 6 * scale, bbox.top + 5 * scale);
    }
    ctx.restore();
  };

  // The charts of one section share their time axis.
  const linkedGroup = (key, panels) => {
    let first = Infinity;
    let last = -Infinity;
    for (const panel of panels) {
      if (!panel.time.length) continue;
      first = Math.min(first, panel.time[0]);
      last = Math.max(last, panel.time[panel.time.length - 1]);
    }
    if (!(first < last)) [first, last] = first === last ? [first - 1, last + 1] : [0, 1];
    const group = {key, first, last, plots: [], onZoom: [], isZoomed: false};
    group.zoom = (min, max) => {
      group.isZoomed = min > group.first || max < group.last;
      for (const plot of group.plots) {
        const x = plot.scales.x;
        if (x.min !== min || x.max !== max) plot.setScale("x", {min, max});
      }
      for (const listener of group.onZoom) listener(group.isZoomed);
    };
    return group;
  };

  // The edges of the bands of those curves that have one: low and high of each in turn. They come
  // before the curves, as curves without ink, so that a band does not tint what lies over it.
  const edgesOf = (series) => series.flatMap((one) => (one.low ? [one.low, one.high] : []));

  const makePlot = (group, panel, place, {label, series, height, hasTimeLabel}) => {
    const own = [panel.time[0], panel.time[panel.time.length - 1]];
    const ink = () => colorOf("muted");
    const grid = () => colorOf("grid");
    const axis = {stroke: ink, font: FONT, labelFont: FONT, grid: {stroke: grid, width: 1},
                  ticks: {stroke: grid, width: 1, size: 5}};
    const edges = edgesOf(series);
    const offset = panel.time_offset ? ` + ${panel.time_offset}` : "";
    const plot = new uPlot({
      width: place.clientWidth || 900,
      height,
      legend: {show: false},
      padding: [8, 12, 0, 0],
      cursor: {sync: {key: group.key, scales: ["x", null]}, drag: {x: true, y: false, dist: 4},
               focus: {prox: -1}, y: false, points: {size: 7, width: 1.5}},
      focus: {alpha: 0.25},
      scales: {
        // Unzoomed, every chart of the group shows the stretch of the longest.
        x: {time: false,
            range: (_, min, max) =>
              (min == null || (min === own[0] && max === own[1]) ? [group.first, group.last] : [min, max])},
      },
      axes: [
        hasTimeLabel ? {...axis, label: `time [s]${offset}`, labelSize: 20, size: 30}
                     : {...axis, size: 10, values: (_, ticks) => ticks.map(() => "")},
        {...axis, label, labelSize: 22, size: AXIS_WIDTH - 22, space: 26},
      ],
      bands: series.flatMap((one, i) => {
        if (!one.low) return [];
        const low = 1 + 2 * series.slice(0, i).filter((other) => other.low).length;
        return [{series: [low + 1, low], fill: `${one.color}38`}];
      }),
      series: [{}, ...edges.map(() => ({width: 0, spanGaps: false, points: {show: false}})), ...series.map((one) => ({
        label: one.name,
        stroke: () => shown(one.color),
        width: one.width,
        spanGaps: false,
        paths: panel.is_stepped ? uPlot.paths.stepped({align: 1}) : undefined,
        points: {show: panel.time.length <= FEW_STAMPS, size: 5, fill: () => shown(one.color)},
      }))],
      hooks: {
        drawClear: [shade(panel.held_out)],
        draw: [labelShades(panel.held_out)],
        setScale: [(self, scale) => {
          if (scale === "x") group.zoom(self.scales.x.min, self.scales.x.max);
        }],
      },
    }, [panel.time, ...edges, ...series.map((one) => one.values)], place);
    plot.ctx.canvas.setAttribute("role", "img");
    plot.ctx.canvas.setAttribute("aria-label", `${label} over time: ${series.map((one) => one.name).join(", ")}`);
    group.plots.push(plot);
    new ResizeObserver(() => {
      if (place.clientWidth && place.clientWidth !== plot.width) {
        plot.setSize({width: place.clientWidth, height});
      }
    }).observe(place);
    return plot;
  };

  // One button for each curve: shows and hides it, and reads out its value below the cursor.
  const makeLegend = (group, panel, curves) => {
    const hasNotes = curves.some((curve) => curve.note);
    const legend = element("div", hasNotes ? "legend" : "legend one-line");
    // A stamp is told from the next one.
    const step = (panel.time[panel.time.length - 1] - panel.time[0]) / (panel.time.length - 1) || 1;
    const timeDecimals = Math.min(Math.max(Math.ceil(-Math.log10(step) - 0.01), 0), 5);
    const time = element("span", "time-read-out");
    const buttons = curves.map((curve) => {
      const button = element("button", "");
      button.type = "button";
      button.setAttribute("aria-pressed", "true");
      button.title = "Show or hide";
      const swatch = element("span", "swatch");
      swatch.style.background = shown(curve.color);
      swatch.dataset.color = curve.color;
      const name = element("span", "key-name", curve.name);
      // Until the cursor is in the chart the place of the value tells something else.
      const atRest = curve.note || (hasNotes && curve === curves[0] ? "hover to read values" : "");
      const readOut = element("span", "read-out", atRest);
      button.append(swatch, name, readOut);
      button.addEventListener("click", () => {
        const show = button.getAttribute("aria-pressed") === "false";
        button.setAttribute("aria-pressed", String(show));
        for (const [plot, index] of [...curve.drawn, ...(curve.edges ?? [])]) plot.setSeries(index, {show});
      });
      button.addEventListener("mouseenter", () => {
        for (const [plot, index] of curve.drawn) plot.setSeries(index, {focus: true});
      });
      button.addEventListener("mouseleave", () => {
        for (const [plot] of curve.drawn) plot.setSeries(null, {focus: true});
      });
      legend.append(button);
      return {readOut, curve, atRest};
    });
    const reset = element("button", "reset", "Reset zoom");
    reset.type = "button";
    reset.hidden = true;
    reset.addEventListener("click", () => group.zoom(group.first, group.last));
    group.onZoom.push((isZoomed) => { reset.hidden = !isZoomed; });
    legend.append(reset, time);

    const valueFormat = formatterFor(curves.map((curve) => curve.values));
    const residualFormat = formatterFor(curves.map((curve) => curve.residual ?? []));
    legend.update = (index) => {
      const isOutside = index == null;
      time.textContent = isOutside ? "" : `t = ${(panel.time[index] + panel.time_offset).toFixed(timeDecimals)} s`;
      for (const {readOut, curve, atRest} of buttons) {
        let text = atRest;
        if (!isOutside) {
          text = valueFormat(curve.values[index]);
          if (panel.unit) text += ` ${panel.unit}`;
          if (curve.residual) text += `  Δ ${residualFormat(curve.residual[index])}`;
        }
        readOut.textContent = text;
      }
    };
    return legend;
  };

  const drawPanel = (group, panel, place) => {
    if (!panel.time.length) {
      place.append(element("p", "hint", "No data."));
      return null;
    }
    const curves = [];
    if (panel.measured) curves.push({...panel.measured, width: 2.5, drawn: []});
    for (const response of panel.responses) curves.push({...response, width: 1.6, drawn: []});
    if (panel.has_residuals) {
      const measured = panel.measured.values;
      for (const curve of curves.slice(1)) {
        curve.residual = curve.values.map(
          (value, i) => (value == null || measured[i] == null ? null : measured[i] - value));
      }
    }

    const legend = makeLegend(group, panel, curves);
    place.append(legend);
    const plots = [];
    const heights = panel.is_low ? LOW_HEIGHTS : HEIGHTS;
    const isSmall = !panel.measured && curves.length === 1;
    plots.push(makePlot(group, panel, place, {
      label: withUnit(panel.quantity, panel.unit), series: curves,
      height: isSmall ? heights.lone : heights.response, hasTimeLabel: !panel.has_residuals,
    }));
    let edge = 0;
    for (const curve of curves) if (curve.low) curve.edges = [[plots[0], ++edge], [plots[0], ++edge]];
    curves.forEach((curve, i) => curve.drawn.push([plots[0], edge + i + 1]));
    if (panel.has_residuals) {
      plots.push(makePlot(group, panel, place, {
        label: withUnit("residual", panel.unit),
        series: curves.slice(1).map((curve) => ({...curve, values: curve.residual, low: null, width: 1.2})),
        height: heights.residual, hasTimeLabel: true,
      }));
      curves.slice(1).forEach((curve, i) => curve.drawn.push([plots[1], i + 1]));
    }
    for (const plot of plots) {
      plot.hooks.setCursor = [(self) => legend.update(self.cursor.left >= 0 ? self.cursor.idx : null)];
    }
    return {panel, curves, legend, plots};
  };

  const sections = JSON.parse(document.getElementById("data").textContent);
  const groups = sections.map((panels, index) => linkedGroup(`section-${index}`, panels));
  const drawn = [];
  for (const place of document.querySelectorAll(".chart")) {
    const group = groups[place.dataset.section];
    const one = drawPanel(group, sections[place.dataset.section][place.dataset.panel], place);
    if (!one) continue;
    if (!drawn.some((other) => other.group === group)) {
      place.append(element("p", "hint on-screen",
        "Drag to zoom, double-click to reset; a click on a name hides its curve."));
    }
    drawn.push({...one, group});
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

  // Uses the first panel as a reader would and writes what happened into the page; for the tests.
  const selfTest = async () => {
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
  if (location.hash === "#selftest") selfTest().catch((error) => {
    const report = element("pre", "", `failed=${error}`);
    report.id = "selftest";
    document.body.append(report);
  });
  // "#zoom=20,40" opens the page with every chart zoomed to these times.
  const zoom = /^#zoom=([-0-9.]+),([-0-9.]+)$/.exec(location.hash);
  if (zoom) for (const group of groups) group.zoom(Number(zoom[1]), Number(zoom[2]));
})();
