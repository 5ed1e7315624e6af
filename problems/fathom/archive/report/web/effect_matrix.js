// Which effects the logs of a dive named: a row for each effect, a column for each dive.
const CELL = {height: 24, least: 5, most: 34, number: 17};  // [px]
const PAGE_ON_PAPER = 680;  // [px]
const NOT_DIAGNOSED = "not diagnosed";

// Rows of counts for each dive: causes, the most frequent first, then verdicts without a cause. Of
// a dive, a log is in the row of each of its causes, in that of its verdict, or in the last.
const matrixRows = (dives, dof) => {
  const causes = new Map();
  const verdicts = new Map([["consistent", []], ["ambiguous", []], ["unexplained", []], [NOT_DIAGNOSED, []]]);
  const add = (rows, name, dive, count) => {
    if (!rows.has(name)) rows.set(name, []);
    rows.get(name)[dive] = count;
  };
  dives.forEach((dive, index) => {
    const {causes: named = {}, verdicts: given = {}} = dive.dofs[dof] ?? {};
    let diagnosed = 0;
    for (const [name, count] of Object.entries(given)) {
      diagnosed += count;
      if (name !== "explained") add(verdicts, name, index, count);
    }
    for (const [name, count] of Object.entries(named)) add(causes, name, index, count);
    if (dive.logs.length > diagnosed) add(verdicts, NOT_DIAGNOSED, index, dive.logs.length - diagnosed);
  });
  const total = (counts) => counts.reduce((sum, count) => sum + count, 0);
  const ofCauses = [...causes].sort((a, b) => total(b[1]) - total(a[1]));
  return [...ofCauses.map(([name, counts]) => ({name, counts, kind: "cause"})),
          ...[...verdicts].map(([name, counts]) => ({name, counts, kind: spaced(name).replace(" ", "-")}))];
};

// A sentence for what a cell holds.
const cellTitle = (row, count, names) => {
  const where = names.length > 1 ? `${names[0]} to ${names[names.length - 1]}` : names[0];
  const what = row.kind === "cause" ? `${count === 1 ? "names" : "name"} ${spaced(row.name)}` : spaced(row.name);
  return `${where}: ${counted(count, "log")} ${what}`;
};

const matrixHeight = (rows) => rows.length * CELL.height + 24;

const drawEffectMatrix = (svg, rows, dives, width) => {
  const left = Math.min(170, Math.round(0.34 * width));
  const numColumns = Math.min(dives.length, Math.floor((width - left) / CELL.least));
  const each = Math.ceil(dives.length / numColumns);
  const columns = Array.from({length: Math.ceil(dives.length / each)},
                             (_, i) => dives.slice(i * each, (i + 1) * each).map(diveName));
  const column = Math.min((width - left) / columns.length, CELL.most);
  const gap = column > 10 ? 2 : 0.5;
  const height = matrixHeight(rows);
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.replaceChildren();
  rows.forEach((row, i) => {
    const top = i * CELL.height;
    const label = drawing("text", {class: "row-name", x: 0, y: top + CELL.height / 2, dy: "0.35em"},
                          ellipsis(spaced(row.name), Math.floor(left / 6.9)));
    label.append(drawing("title", {}, spaced(row.name)));
    svg.append(label, drawing("rect", {class: "back", x: left, y: top + 1, width: (columns.length * column).toFixed(1),
                                       height: CELL.height - 2}));
    columns.forEach((names, c) => {
      const from = c * each;
      let count = 0;
      let logs = 0;
      for (let dive = from; dive < from + names.length; ++dive) {
        count += row.counts[dive] ?? 0;
        logs += dives[dive].logs.length;
      }
      if (!count) return;
      const x = left + c * column;
      const cell = drawing("rect", {class: `cell ${row.kind}`, x: (x + gap / 2).toFixed(2), y: top + 2,
                                    width: (column - gap).toFixed(2), height: CELL.height - 4,
                                    "fill-opacity": (0.35 + 0.65 * Math.min(count / logs, 1)).toFixed(2)});
      cell.append(drawing("title", {}, cellTitle(row, count, names)));
      svg.append(cell);
      if (column < CELL.number || count > 99) return;
      svg.append(drawing("text", {class: `count ${row.kind} ${count / logs > 0.5 ? "dark" : ""}`, x: (x + column / 2).toFixed(1),
                                  y: top + CELL.height / 2, dy: "0.35em", "text-anchor": "middle"}, count));
    });
  });
  axisLabels(svg, columns.map((names) => names[0]), (i) => left + (i + 0.5) * column, height - 6, left - 10, width);
  return each;
};

const showEffectMatrices = (place, dives) => {
  const isDiagnosed = dofsOf(dives).filter((dof) => dives.some((dive) => dive.dofs[dof]?.verdicts));
  if (!isDiagnosed.length) place.append(element("p", "text", "No log was diagnosed."));
  for (const dof of isDiagnosed) {
    const rows = matrixRows(dives, dof);
    const svg = drawing("svg", {class: "matrix", role: "img", "aria-label": `logs by effect and dive, ${dof}`});
    svg.style.height = `${matrixHeight(rows)}px`;
    const hint = element("p", "hint");
    place.append(element("h3", "", capitalised(dof)), svg, hint);
    drawToFit(place, (width) => {
      const each = drawEffectMatrix(svg, rows, dives, width);
      hint.textContent = each > 1 ? `A column holds ${each} dives and bears the name of the first.` : "";
    }, PAGE_ON_PAPER);
  }
};
