"use strict";
// One plot over time, and the group that zooms with it.

const AXIS_WIDTH = 72;         // [px], the same everywhere so that the time axes line up
const FEW_STAMPS = 60;         // up to here each stamp gets a dot

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
// Above the shade, where no curve runs.
const labelShades = (held_out) => (plot) => {
  const {ctx, bbox} = plot;
  const scale = uPlot.pxRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, 0, bbox.width, bbox.top);
  ctx.clip();
  ctx.font = FONT.replace("12px", `${12 * scale}px`);
  ctx.fillStyle = colorOf("held-out-ink");
  ctx.textBaseline = "bottom";
  ctx.textAlign = "left";
  for (const [from, to] of held_out) {
    const left = Math.max(plot.valToPos(from, "x", true), bbox.left);
    const right = Math.min(plot.valToPos(to, "x", true), bbox.left + bbox.width);
    if (right - left > 60 * scale) ctx.fillText("held out", left + 2 * scale, bbox.top - 3 * scale);
  }
  ctx.restore();
};

// The marks at which silences are cut out of the axis.
const markCuts = (cuts) => (plot) => {
  const {ctx, bbox} = plot;
  const scale = uPlot.pxRatio;
  const bottom = bbox.top + bbox.height;
  ctx.save();
  ctx.strokeStyle = colorOf("muted");
  ctx.lineWidth = 1.2 * scale;
  for (const {from, to} of cuts) {
    const left = plot.valToPos(placeOf(cuts, from), "x", true);
    const right = plot.valToPos(placeOf(cuts, to), "x", true);
    if (left < bbox.left || right > bbox.left + bbox.width) continue;
    ctx.fillStyle = colorOf("paper");
    ctx.fillRect(left, bbox.top, right - left, bbox.height + scale);
    const middle = (left + right) / 2;
    for (const x of [middle - 2 * scale, middle + 2 * scale]) {
      ctx.beginPath();
      ctx.moveTo(x - 3 * scale, bottom + 6 * scale);
      ctx.lineTo(x + 3 * scale, bottom - 6 * scale);
      ctx.stroke();
    }
  }
  ctx.restore();
};

// The charts of one section share their time axis. Its places are times with the silences cut out.
const linkedGroup = (key, panels) => {
  const cuts = cutsBetween(stretchesOf(panels));
  const place = (time) => placeOf(cuts, time);
  for (const panel of panels) {
    panel.places = cuts.length ? panel.time.map(place) : panel.time;
    panel.held_out = panel.held_out.map((interval) => interval.map(place));
  }
  let first = Infinity;
  let last = -Infinity;
  for (const panel of panels) {
    if (!panel.places.length) continue;
    first = Math.min(first, panel.places[0]);
    last = Math.max(last, panel.places[panel.places.length - 1]);
  }
  if (!(first < last)) [first, last] = first === last ? [first - 1, last + 1] : [0, 1];
  const group = {key, cuts, first, last, plots: [], onZoom: [], isZoomed: false};
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

// Draws a curve anew after it was asked for or pointed at.
const repaint = (curve) => {
  for (const [plot, index, width] of curve.drawn) {
    plot.series[index].width = widthOf(curve, width);
    plot.redraw(false);
  }
};

// The edges of the bands of those curves that have one: low and high of each in turn. They come
// before the curves, as curves without ink, so that a band does not tint what lies over it.
const edgesOf = (series) => series.flatMap((one) => (one.low ? [one.low, one.high] : []));

// The font of a name that has so many px beside its axis: smaller where it would be cut off.
const fontWithin = (name, length) => {
  const pen = document.createElement("canvas").getContext("2d");
  pen.font = FONT;
  const size = Math.min(12, Math.floor((12 * length) / pen.measureText(name).width));
  return FONT.replace("12px", `${size}px`);
};

const LABEL_HEIGHT = 20;  // [px], of what stands above a shade

// Between the numbers of an axis of such a length [px]: a low chart has two of them too.
const spaceOf = (plot, index, from, to, length) => Math.max(14, Math.min(26, length / 4));

const makePlot = (group, panel, place, {label, series, height, hasTimeLabel}) => {
  const own = [panel.places[0], panel.places[panel.places.length - 1]];
  const ink = () => colorOf("muted");
  const grid = () => colorOf("grid");
  const axis = {stroke: ink, font: FONT, labelFont: FONT, grid: {stroke: grid, width: 1},
                ticks: {stroke: grid, width: 1, size: 5}};
  const {cuts} = group;
  const timeAxis = cuts.length ? {
    ...axis,
    splits: (_, index, min, max, step) => roundTimes(cuts, [min, max], step).map((time) => placeOf(cuts, time)),
    values: (_, places) => places.map((one) => uPlot.fmtNum(Number(timeOf(cuts, one).toFixed(6)))),
  } : axis;
  const edges = edgesOf(series);
  const offset = panel.time_offset ? ` + ${panel.time_offset}` : "";
  const plot = new uPlot({
    width: place.clientWidth || 900,
    height,
    legend: {show: false},
    padding: [panel.held_out.length ? LABEL_HEIGHT : 8, 12, 0, 0],
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
      hasTimeLabel ? {...timeAxis, label: `time [s]${offset}`, labelSize: 20, size: 30}
                   : {...timeAxis, size: 10, values: (_, ticks) => ticks.map(() => "")},
      {...axis, label, labelFont: fontWithin(label, height + 8 - (hasTimeLabel ? 50 : 10)), labelSize: 22, size: AXIS_WIDTH - 22, space: spaceOf},
    ],
    bands: series.flatMap((one, i) => {
      if (!one.low) return [];
      const low = 1 + 2 * series.slice(0, i).filter((other) => other.low).length;
      return [{series: [low + 1, low], fill: `${one.curve.color}38`}];
    }),
    series: [{}, ...edges.map(() => ({width: 0, spanGaps: false, points: {show: false}})), ...series.map((one) => ({
      label: one.curve.name,
      stroke: () => strokeOf(one.curve),
      width: widthOf(one.curve, one.width),
      spanGaps: false,
      paths: panel.is_stepped ? uPlot.paths.stepped({align: 1}) : undefined,
      points: {show: panel.time.length <= FEW_STAMPS, size: 5, fill: () => strokeOf(one.curve)},
    }))],
    hooks: {
      drawClear: [shade(panel.held_out)],
      draw: [markCuts(cuts), labelShades(panel.held_out)],
      setScale: [(self, scale) => {
        if (scale === "x") group.zoom(self.scales.x.min, self.scales.x.max);
      }],
    },
  }, [panel.places, ...edges, ...series.map((one) => one.values)], place);
  plot.ctx.canvas.setAttribute("role", "img");
  plot.ctx.canvas.setAttribute("aria-label", `${label} over time: ${series.map((one) => one.curve.name).join(", ")}`);
  group.plots.push(plot);
  new ResizeObserver(() => {
    if (place.clientWidth && place.clientWidth !== plot.width) {
      plot.setSize({width: place.clientWidth, height});
    }
  }).observe(place);
  return plot;
};
