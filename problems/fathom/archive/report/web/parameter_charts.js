// Parameters over dives, from what parameter_charts_json.cc writes.
const CHART = {height: 200, left: 58, right: 10, top: 20, bottom: 26};  // [px]
const STDS_OF_95 = 1.96;
const MANY_DIVES = 150;  // from here on dots and bars are thinner
const COLUMN_ON_PAPER = 330;  // [px]

// What the changes make of a parameter: the level before and after each step, from one step to the
// next. Where there is a trend too, its line from one step to the next, moved by each of them.
const changePaths = (changes, numPlaces, x, y) => {
  const steps = changes.filter(({kind}) => kind === "step").sort((a, b) => a.at - b.at);
  const trend = changes.find(
    ({kind, before, after}) => kind !== "step" && before != null && after != null);
  const slope = trend ? (trend.after - trend.before) / Math.max(numPlaces - 1 - trend.at, 1) : 0;
  const line = (from, to, valueAt) =>
    `M${x(from).toFixed(1)} ${y(valueAt(from)).toFixed(1)}L${x(to).toFixed(1)} ${y(valueAt(to)).toFixed(1)}`;
  let levels = "";
  let borders = "";
  let moved = 0;  // by the steps so far
  for (let i = 0; i <= steps.length; ++i) {
    const first = i > 0 ? steps[i - 1].at - 0.5 : trend ? trend.at : -0.5;
    const last = i < steps.length ? steps[i].at - 0.5 : trend ? numPlaces - 1 : numPlaces - 0.5;
    if (i > 0) {
      moved += steps[i - 1].after - steps[i - 1].before;
      borders += `M${x(first).toFixed(1)} ${CHART.top}V${CHART.height - CHART.bottom}`;
    }
    if (trend) {
      const offset = moved;
      levels += line(first, last, (place) => trend.before + slope * (place - trend.at) + offset);
      continue;
    }
    const level = i > 0 ? steps[i - 1].after : steps[0]?.before;
    if (level != null) levels += line(first, last, () => level);
  }
  return {steps, levels, borders};
};

// Dots, bars, diamonds and arrows as the outlines of one path each. A bar ends at what the parameter can
// be, unless its value lies beyond.
const pointPaths = (points, outliers, x, y, bound) => {
  const top = CHART.top;
  const bottom = CHART.height - CHART.bottom;
  const paths = {bars: "", dots: "", diamonds: "", arrows: ""};
  const arrow = (at, isUp) => {
    const tip = isUp ? top : bottom;
    const base = isUp ? 6 : -6;
    paths.arrows += `M${at} ${tip}l4 ${base}h-8z`;
  };
  for (const [place, value, std] of points) {
    const at = x(place).toFixed(1);
    const middle = y(value);
    const half = STDS_OF_95 * (std ?? 0);
    const least = value >= bound ? Math.max(value - half, bound) : value - half;
    const [high, low] = [y(value + half), y(least)];
    const [from, to] = [Math.max(high, top), Math.min(low, bottom)];
    if (to > from) paths.bars += `M${at} ${from.toFixed(1)}V${to.toFixed(1)}`;
    if (high < top - 0.5) arrow(at, true);
    if (low > bottom + 0.5) arrow(at, false);
    if (middle < top - 0.5 || middle > bottom + 0.5) continue;
    if (outliers.has(place)) paths.diamonds += `M${at} ${(middle - 6).toFixed(1)}l6 6l-6 6l-6 -6z`;
    else paths.dots += `M${at} ${middle.toFixed(1)}h0`;
  }
  return paths;
};

const drawParameterChart = (svg, chart, names, width) => {
  const [from, to] = chart.range;
  const right = width - CHART.right;
  const bottom = CHART.height - CHART.bottom;
  const x = (place) => CHART.left + (place + 0.5) * (right - CHART.left) / names.length;
  const y = (value) => bottom - (value - from) / (to - from) * (bottom - CHART.top);
  svg.setAttribute("viewBox", `0 0 ${width} ${CHART.height}`);
  svg.setAttribute("class", names.length > MANY_DIVES ? "trend many" : "trend");
  svg.replaceChildren();

  for (const [value, label] of chart.ticks) {
    const at = y(value).toFixed(1);
    svg.append(drawing("path", {class: "grid", d: `M${CHART.left} ${at}H${right}`}),
               drawing("text", {x: CHART.left - 8, y: at, dy: "0.35em", "text-anchor": "end"}, label));
  }
  const present = new Set(chart.points.map(([place]) => place));
  const missing = [...names.keys()].filter((place) => !present.has(place));
  svg.append(drawing("path", {class: "missing", d: missing.map((place) => `M${x(place).toFixed(1)} ${bottom}v-7`).join("")}),
             drawing("path", {class: "axis-line", d: `M${CHART.left} ${bottom}H${right}`}));
  axisLabels(svg, names, x, CHART.height - 8, CHART.left - 10, width);

  const change = changePaths(chart.changes, names.length, x, y);
  const marks = pointPaths(chart.points, new Set(chart.outliers), x, y, chart.lower_bound ?? -Infinity);
  svg.append(drawing("path", {class: "border", d: change.borders}),
             drawing("path", {class: "bars", d: marks.bars}),
             drawing("path", {class: "dots", d: marks.dots}),
             drawing("path", {class: "levels", d: change.levels}),
             drawing("path", {class: "diamonds", d: marks.diamonds}),
             drawing("path", {class: "arrows", d: marks.arrows}));
  let free = CHART.left;  // a name at the top does not run into the one before it
  for (const {at, name} of change.steps) {
    const text = ellipsis(`from ${name}`, 24);
    const size = CHARACTER * text.length;
    const begin = Math.min(x(at - 0.5) - 2, right - size);
    if (begin < free) continue;
    free = begin + size + 8;
    svg.append(drawing("text", {class: "change-name", x: begin.toFixed(1), y: CHART.top - 7}, text));
  }
  const ring = drawing("circle", {class: "ring", r: 7, visibility: "hidden"});
  svg.append(ring);
  return {x, y: (value) => Math.min(Math.max(y(value), CHART.top), bottom), ring};
};

// The chart with its name and what it reads out below the pointer or at the arrow keys.
const parameterFigure = (chart, dof, names) => {
  chart.points.sort((a, b) => a[0] - b[0]);
  const figure = element("figure", "over-dives");
  const caption = element("figcaption");
  const readOut = element("span", "read-out");
  readOut.setAttribute("aria-live", "polite");
  caption.append(element("b", "", spaced(chart.parameter)), element("span", "", chart.unit ? `[${chart.unit}]` : ""), readOut);
  const svg = drawing("svg", {tabindex: 0, role: "img",
    "aria-label": `${spaced(chart.parameter)} of ${dof} over ${counted(names.length, "dive")}; arrow keys read the dots`});
  figure.append(caption, svg);

  let view = null;
  let chosen = -1;
  const choose = (index) => {
    chosen = index;
    const point = chart.points[index];
    view.ring.setAttribute("visibility", point ? "visible" : "hidden");
    readOut.textContent = "";
    if (!point) return;
    view.ring.setAttribute("cx", view.x(point[0]));
    view.ring.setAttribute("cy", view.y(point[1]));
    const isOutlier = chart.outliers.includes(point[0]);
    readOut.textContent = `${names[point[0]]}: ${point[3]}${chart.unit ? ` ${chart.unit}` : ""}${isOutlier ? ", outlier" : ""}`;
  };
  const nearest = (left, top) => {
    let best = -1;
    let least = Infinity;
    chart.points.forEach(([place, value], index) => {
      const distance = Math.abs(view.x(place) - left) + 0.1 * Math.abs(view.y(value) - top);
      if (distance < least) [best, least] = [index, distance];
    });
    return best;
  };
  svg.addEventListener("pointermove", (event) => {
    const box = svg.getBoundingClientRect();
    choose(nearest(event.clientX - box.left, event.clientY - box.top));
  });
  svg.addEventListener("pointerleave", () => choose(-1));
  svg.addEventListener("blur", () => choose(-1));
  svg.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (!step) return;
    event.preventDefault();
    choose(Math.min(Math.max(chosen + step, 0), chart.points.length - 1));
  });
  return {figure, draw: (width) => { view = drawParameterChart(svg, chart, names, width); }};
};

// What only one dive tells is no chart, but a row: parameter, value, dive.
const loneTable = (charts, names) => {
  const table = element("table", "lone");
  for (const {parameter, unit, points} of charts) {
    const [place, , , text] = points[0];
    const row = element("tr");
    row.append(element("th", "", spaced(parameter)), element("td", "", unit ? `${text} ${unit}` : text),
               element("td", "", names[place]));
    table.append(row);
  }
  return table;
};

const showParameterCharts = (place, groups, dives) => {
  const vehicles = new Set(groups.map(({vehicle}) => vehicle));
  for (const {vehicle, dof, dives: own, charts} of groups) {
    const dofs = dof.split(",").join(", ");
    place.append(element("h3", "", capitalised(vehicles.size > 1 && vehicle ? `${dofs}, ${vehicle}` : dofs)));
    if (!charts.length) {
      place.append(element("p", "hint", "No dive has a usable joint fit."));
      continue;
    }
    const grid = element("div", "chart-grid");
    const names = own.map((index) => diveName(dives[index]));
    const lone = charts.filter(({points}) => points.length === 1);
    if (lone.length) place.append(loneTable(lone, names));
    const figures = charts.filter((chart) => !lone.includes(chart)).map((chart) => parameterFigure(chart, dof, names));
    if (!figures.length) continue;
    grid.append(...figures.map(({figure}) => figure));
    place.append(grid);
    drawToFit(figures[0].figure, (width) => { for (const {draw} of figures) draw(width); }, COLUMN_ON_PAPER);
  }
  if (!groups.length) place.append(element("p", "text", "No dive has a joint fit."));
};
