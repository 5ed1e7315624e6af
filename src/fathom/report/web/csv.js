"use strict";
// The data of a chart as a file of comma-separated values.

const csvField = (value) => {
  const text = String(value ?? "");
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

// Columns {name, values}; the first one says where. Rows that hold nothing else are gaps of the drawing
// and left out.
const csvOf = (columns) => {
  const lines = [columns.map(({name}) => csvField(name)).join(",")];
  columns[0].values.forEach((_, row) => {
    const cells = columns.map(({values}) => values[row]);
    if (cells.slice(1).some((cell) => cell != null)) lines.push(cells.map(csvField).join(","));
  });
  return `${lines.join("\n")}\n`;
};

// What a panel over time draws, by its true time.
const columnsOf = (panel) => {
  const time = panel.time.map((t) => Number((t + panel.time_offset).toFixed(5)));
  const curves = [...(panel.measured ? [panel.measured] : []), ...panel.responses];
  return [{name: "time [s]", values: time}, ...curves.flatMap(({name, values, low, high}) => [
    {name: withUnit(name, panel.unit), values},
    ...(low ? [{name: withUnit(`${name}, low`, panel.unit), values: low},
               {name: withUnit(`${name}, high`, panel.unit), values: high}] : []),
  ])];
};

// A button that saves them; it needs no network.
const saveButton = (title, columns) => {
  const button = element("button", "save on-screen", "Save as CSV");
  button.type = "button";
  button.setAttribute("aria-label", `Save the data of ${title} as CSV`);
  button.addEventListener("click", () => {
    const link = element("a", "");
    link.href = URL.createObjectURL(new Blob([csvOf(columns())], {type: "text/csv"}));
    link.download = `${`${document.title} ${title}`.replace(/[^\p{L}\p{N}]+/gu, "_")}.csv`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
  return button;
};
