// The table of dives: filter, sort, and the logs of a dive below its row.
const ROWS_IN_SIGHT = 100;
const LINKS_IN_SIGHT = 3;

const worstOf = (dive, key) => {
  const known = Object.values(dive.dofs).map((dof) => dof[key]).filter((value) => value != null);
  return known.length ? Math.max(...known) : null;
};
const ratioText = (value) => (value == null ? "–" : value.toFixed(3));

// "3 ok, 1 crashed".
const statesText = (dive, logs) => {
  const counts = new Map();
  for (const log of dive.logs) counts.set(logs[log][1], (counts.get(logs[log][1]) ?? 0) + 1);
  return [...counts].map(([state, count]) => `${count} ${state}`).join(", ");
};
const causesOf = (dofs) => {
  const counts = new Map();
  for (const {causes = {}} of Object.values(dofs)) {
    for (const [name, count] of Object.entries(causes)) counts.set(name, (counts.get(name) ?? 0) + count);
  }
  return [...counts].sort((a, b) => b[1] - a[1]).map(([name]) => spaced(name)).join(", ");
};
const findingsText = ({red, yellow}) =>
  [red ? `${red} red` : "", yellow ? `${yellow} yellow` : ""].filter(Boolean).join(", ");

// `text` is shown, `value` sorted by.
const diveColumns = (logs) => [
  {name: "dive", text: diveName, value: (dive) => dive.place},
  {name: "start", text: (dive) => dive.start.replace("T", " ").replace(/(:\d\d)?(\.\d+)?Z$/, ""), value: (dive) => dive.start},
  {name: "logs", isNumber: true, text: (dive) => dive.logs.length, value: (dive) => dive.logs.length},
  {name: "states", text: (dive) => statesText(dive, logs), value: (dive) => dive.lost},
  {name: "DOFs with a model", text: (dive) => dofsOf([dive]).filter((dof) => dive.dofs[dof].model).join(", ") || "–",
   value: (dive) => Object.values(dive.dofs).filter(({model}) => model).length},
  {name: "held-out NMAE", isNumber: true, text: (dive) => ratioText(worstOf(dive, "h")), value: (dive) => worstOf(dive, "h")},
  {name: "prediction NMAE", isNumber: true, text: (dive) => ratioText(worstOf(dive, "p")),
   value: (dive) => worstOf(dive, "p")},
  {name: "causes named", text: (dive) => causesOf(dive.dofs) || "–", value: (dive) => causesOf(dive.dofs)},
  {name: "findings", text: (dive) => findingsText(dive) || "–", value: (dive) => 1e6 * dive.red + dive.yellow},
];

const pageLinks = (log) => Object.entries(log[3]).sort(([a], [b]) => dofOrder(a) - dofOrder(b)).map(([dof, address]) => {
  const link = element("a", "", dof);
  link.href = address;
  link.title = `Diagnosis of ${dof}, ${log[0]}`;
  return link;
});

const logsOfDive = (dive, logs, numColumns) => {
  const row = element("tr", "logs-of-dive");
  const cell = element("td");
  cell.colSpan = numColumns;
  const list = element("ul");
  for (const index of dive.logs) {
    const [path, state, message] = logs[index];
    const item = element("li");
    item.append(element("b", "", path), element("span", "state", state));
    if (message) item.append(element("span", "message", message));
    const links = pageLinks(logs[index]);
    if (links.length) item.append(element("span", "message", "Diagnosis:"), ...links);
    list.append(item);
  }
  if (!dive.logs.length) list.append(element("li", "", "This dive has no logs."));
  cell.append(list);
  row.append(cell);
  return row;
};

const diveRow = (dive, columns, logs) => {
  const row = element("tr", dive.lost || dive.red ? "dive-row bad" : "dive-row");
  let button = null;
  for (const column of columns) {
    const cell = element("td", column.isNumber ? "number" : "");
    cell.dataset.name = column.name;
    if (column.name === "dive") {
      button = element("button", "opener", column.text(dive));
      button.type = "button";
      button.setAttribute("aria-expanded", "false");
      button.title = "Show the logs of this dive";
      let opened = null;
      button.addEventListener("click", () => {
        if (opened) opened.remove();
        opened = opened ? null : logsOfDive(dive, logs, columns.length + 1);
        if (opened) row.after(opened);
        button.setAttribute("aria-expanded", String(opened !== null));
      });
      cell.append(button);
    } else {
      cell.textContent = column.text(dive);
    }
    row.append(cell);
  }
  // Of many logs the links stand with each log.
  const links = dive.logs.flatMap((log) => pageLinks(logs[log]));
  const cell = element("td", "links");
  cell.dataset.name = "diagnoses";
  if (links.length > LINKS_IN_SIGHT) {
    const more = element("button", "sorter", counted(links.length, "page"));
    more.type = "button";
    more.title = "Show them with the logs of this dive";
    more.addEventListener("click", () => button.click());
    cell.append(more);
  } else {
    cell.append(...(links.length ? links : ["–"]));
  }
  row.append(cell);
  return row;
};

const showDiveTable = (place, {dives, worst, logs}) => {
  dives.forEach((dive, index) => { dive.place = index; });
  const columns = diveColumns(logs);
  const order = {column: null, sign: 1};  // no column: worst first
  let showsAll = false;

  const filter = element("input");
  filter.type = "search";
  filter.placeholder = "dive, state, cause, log …";
  const reset = element("button", "plain", "Worst first");
  const all = element("button", "plain");
  reset.type = all.type = "button";
  const count = element("span", "count-of-rows");
  count.setAttribute("role", "status");
  const controls = element("div", "controls");
  controls.append(labelled("Filter", filter), reset, count);

  const table = element("table", "dive-rows");
  const headings = element("tr");
  const buttons = columns.map((column) => {
    const heading = element("th", column.isNumber ? "number" : "");
    heading.scope = "col";
    const button = element("button", "sorter", column.name);
    button.type = "button";
    button.addEventListener("click", () => {
      // Numbers are looked at for the largest first.
      order.sign = order.column === column ? -order.sign : column.isNumber || column.name === "findings" || column.name === "states" ? -1 : 1;
      order.column = column;
      render();
    });
    heading.append(button);
    headings.append(heading);
    return {heading, column};
  });
  headings.append(element("th", "plain-heading", "diagnoses"));
  const head = element("thead");
  head.append(headings);
  const body = element("tbody");
  table.append(head, body);
  const box = element("div", "table");
  box.append(table);
  place.append(controls, box, all);

  // What the filter looks at; made when it is first used.
  const haystack = (dive) => {
    dive.haystack ??= [...columns.map((column) => column.text(dive)),
                       ...dive.logs.flatMap((log) => logs[log].filter((part) => typeof part === "string"))].join("\n").toLowerCase();
    return dive.haystack;
  };
  const compared = (a, b) => {
    const [one, other] = [order.column.value(a), order.column.value(b)];
    if (one === other) return a.place - b.place;
    if (one == null || one === "") return 1;  // what is not known stands last in either direction
    if (other == null || other === "") return -1;
    return order.sign * (one < other ? -1 : 1);
  };
  const render = () => {
    const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    let found = worst.map((index) => dives[index]);
    if (words.length) found = found.filter((dive) => words.every((word) => haystack(dive).includes(word)));
    if (order.column) found.sort(compared);
    const shown = showsAll ? found : found.slice(0, ROWS_IN_SIGHT);
    body.replaceChildren(...shown.map((dive) => diveRow(dive, columns, logs)));
    count.textContent = shown.length < found.length ? `${shown.length} of ${counted(found.length, "dive")} shown`
                                                    : counted(found.length, "dive");
    all.hidden = shown.length === found.length;
    all.textContent = `Show all ${counted(found.length, "dive")}`;
    reset.hidden = order.column === null;
    for (const {heading, column} of buttons) {
      const sort = order.column === column ? (order.sign > 0 ? "ascending" : "descending") : "none";
      heading.setAttribute("aria-sort", sort);
    }
  };
  filter.addEventListener("input", render);
  reset.addEventListener("click", () => { order.column = null; render(); });
  all.addEventListener("click", () => { showsAll = true; render(); });
  render();
};
