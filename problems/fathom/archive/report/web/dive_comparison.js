// Two dives side by side.
const LARGE_DIFFERENCE = 3;  // [standard deviations]

// The joint fit of a parameter in a dive, or nothing.
const fitOf = (group, chart, dive) => {
  const place = group.dives.indexOf(dive);
  return chart.points.find((point) => point[0] === place) ?? null;
};

// [name, text of one, text of the other, difference in standard deviations or null]
const parameterRows = (groups, one, other) => groups.flatMap((group) => group.charts.map((chart) => {
  const [a, b] = [fitOf(group, chart, one), fitOf(group, chart, other)];
  const std = a && b && a[2] != null && b[2] != null ? Math.hypot(a[2], b[2]) : 0;
  const name = `${group.dof} ${spaced(chart.parameter)}${chart.unit ? ` [${chart.unit}]` : ""}`;
  const several = new Set(groups.map(({vehicle}) => vehicle)).size > 1;
  return [several && group.vehicle ? `${group.vehicle}: ${name}` : name,
          a ? a[3] : "–", b ? b[3] : "–", std > 0 ? (b[1] - a[1]) / std : null];
})).filter(([, a, b]) => a !== "–" || b !== "–");

// What the diagnoses of a dive say of a DOF.
const effectsText = (dive, dof) => {
  const {causes = {}, verdicts = {}} = dive.dofs[dof] ?? {};
  const parts = Object.entries(causes).map(([name, count]) => `${spaced(name)} (${counted(count, "log")})`);
  for (const [name, count] of Object.entries(verdicts)) {
    if (name !== "explained") parts.push(`${name} (${counted(count, "log")})`);
  }
  const rest = dive.logs.length - Object.values(verdicts).reduce((sum, count) => sum + count, 0);
  if (rest > 0) parts.push(`not diagnosed (${counted(rest, "log")})`);
  return parts.join(", ") || "–";
};

const findingsOf = (dive, findings) => {
  const logs = new Set(dive.logs);
  const texts = new Map();
  for (const [log, dof, severity, text] of findings) {
    if (!logs.has(log)) continue;
    const whole = `${capitalised(severity)}${dof ? `, ${dof}` : ""}: ${text}`;
    texts.set(whole, (texts.get(whole) ?? 0) + 1);
  }
  return [...texts].map(([text, count]) => (count > 1 ? `${text} (${counted(count, "log")})` : text));
};

const comparisonRows = (data, one, other) => {
  const {dives, findings, logs} = data.archive;
  const [a, b] = [dives[one], dives[other]];
  const dofs = dofsOf([a, b]);
  const score = (dive, dof, key) => ratioText(dive.dofs[dof]?.[key]);
  return [
    ["Logs", [["states", statesText(a, logs) || "–", statesText(b, logs) || "–", null]]],
    ["Parameters, ± one standard deviation", parameterRows(data.parameters, one, other)],
    ["Effects", dofs.map((dof) => [dof, effectsText(a, dof), effectsText(b, dof), null])],
    ["Held-out NMAE", dofs.map((dof) => [dof, score(a, dof, "h"), score(b, dof, "h"), null])],
    ["Prediction NMAE", dofs.map((dof) => [dof, score(a, dof, "p"), score(b, dof, "p"), null])],
    ["Findings", [["", findingsOf(a, findings).join("\n") || "none", findingsOf(b, findings).join("\n") || "none", null]]],
  ];
};

const comparisonTable = (data, one, other) => {
  const table = element("table", "side-by-side");
  const head = element("thead");
  const headings = element("tr");
  const names = ["", diveName(data.archive.dives[one]), diveName(data.archive.dives[other]), "difference [std]"];
  for (const name of names) headings.append(element("th", "", name));
  head.append(headings);
  table.append(head);
  for (const [caption, rows] of comparisonRows(data, one, other)) {
    if (!rows.length) continue;
    const body = element("tbody");
    const title = element("th", "part", caption);
    title.colSpan = 4;
    title.scope = "rowgroup";
    const first = element("tr");
    first.append(title);
    body.append(first);
    for (const [name, a, b, difference] of rows) {
      const row = element("tr", Math.abs(difference ?? 0) >= LARGE_DIFFERENCE ? "large" : "");
      const heading = element("th", "", name);
      heading.scope = "row";
      const text = difference == null ? "" : `${difference < 0 ? "" : "+"}${difference.toFixed(1)}`;
      row.append(heading, element("td", "", a), element("td", "", b), element("td", "", text));
      body.append(row);
    }
    table.append(body);
  }
  return table;
};

// The dives to either side of the first step, otherwise the first and the last with a joint fit.
const firstPair = ({parameters, archive: {dives}}) => {
  for (const {charts, dives: own} of parameters) {
    for (const {changes} of charts) {
      const step = changes.find(({kind, at}) => kind === "step" && at > 0);
      if (step) return [own[step.at - 1], own[step.at]];
    }
  }
  const fitted = dives.flatMap((dive, index) => (Object.values(dive.dofs).some(({model}) => model) ? [index] : []));
  return fitted.length > 1 ? [fitted[0], fitted[fitted.length - 1]] : [0, dives.length - 1];
};

const showDiveComparison = (place, data) => {
  const {dives} = data.archive;
  if (dives.length < 2) {
    place.append(element("p", "text", "There are no two dives."));
    return;
  }
  const selects = firstPair(data).map((chosen) => {
    const select = element("select");
    dives.forEach((dive, index) => select.append(new Option(diveName(dive), index)));
    select.value = chosen;
    return select;
  });
  const controls = element("div", "controls");
  controls.append(labelled("One dive", selects[0]), labelled("Other dive", selects[1]));
  const box = element("div", "table");
  place.append(controls, box);
  const render = () => box.replaceChildren(comparisonTable(data, ...selects.map(({value}) => Number(value))));
  for (const select of selects) select.addEventListener("change", render);
  render();
};
