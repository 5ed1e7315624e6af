// Making elements. Texts go in as text, never as HTML.
const errors = [];
window.addEventListener("error", (event) => errors.push(event.message));

const element = (tag, kind = "", text = "") => {
  const made = document.createElement(tag);
  if (kind) made.className = kind;
  if (text !== "") made.textContent = text;
  return made;
};

const drawing = (tag, attributes = {}, text = "") => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text !== "") made.textContent = text;
  return made;
};

// A field with its label before it.
const labelled = (text, field) => {
  const label = element("label", "field");
  label.append(element("span", "", text), field);
  return label;
};

const counted = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;
const spaced = (name) => name.replaceAll("_", " ");
const capitalised = (text) => text.charAt(0).toUpperCase() + text.slice(1);

// Names of DOFs in their usual order, others behind.
const DOFS = ["surge", "sway", "heave", "roll", "pitch", "yaw"];
const dofOrder = (dof) => (DOFS.includes(dof) ? DOFS.indexOf(dof) : DOFS.length);
const dofsOf = (dives) =>
  [...new Set(dives.flatMap((dive) => Object.keys(dive.dofs)))].sort((a, b) => dofOrder(a) - dofOrder(b));
const diveName = (dive) => dive.name || "(no dive)";
const ellipsis = (text, most) => (text.length <= most ? text : `${text.slice(0, Math.max(most - 1, 1))}…`);

const CHARACTER = 6.4;  // [px], about as wide as a letter of a chart

// Names below an axis, as many as do not touch each other. `x` gives the middle of each.
const axisLabels = (svg, names, x, y, left, right) => {
  const shown = names.map((name) => ellipsis(name, 16));
  const widest = CHARACTER * Math.max(1, ...shown.map((name) => name.length)) + 14;
  const each = names.length > 1 ? Math.abs(x(1) - x(0)) : widest;
  const stride = Math.max(1, Math.ceil(widest / each));
  for (let i = 0; i < names.length; i += stride) {
    const half = CHARACTER * shown[i].length / 2;
    const middle = Math.min(Math.max(x(i), left + half), right - half);
    svg.append(drawing("text", {x: middle.toFixed(1), y, "text-anchor": "middle"}, shown[i]));
  }
};

// Places that are too far down to be in sight when the page opens, and are drawn when they come near.
const undrawn = new Set();
const NEAR = 600;  // [px]

// Draws anew whenever the width changes; on paper in the width that is given for it.
const drawToFit = (place, draw, paperWidth) => {
  let width = 0;
  const fit = (wanted) => {
    if (!wanted || wanted === width) return;
    width = wanted;
    draw(width);
  };
  const start = () => {
    undrawn.delete(start);
    fit(place.clientWidth);
    new ResizeObserver(() => fit(place.clientWidth)).observe(place);
  };
  undrawn.add(start);
  if (place.getBoundingClientRect().top < window.innerHeight + NEAR) {
    start();
  } else {
    const coming = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      coming.disconnect();
      if (undrawn.has(start)) start();
    }, {rootMargin: `${NEAR}px`});
    coming.observe(place);
  }
  window.addEventListener("beforeprint", () => fit(paperWidth));
  window.addEventListener("afterprint", () => fit(place.clientWidth));
};
