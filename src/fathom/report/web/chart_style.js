"use strict";
// What the charts have in common: colours, elements, numbers as text.

// A colour of page.css, which has others in the dark.
const colorOf = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const isDark = () => window.matchMedia("(prefers-color-scheme: dark)").matches &&
  !document.documentElement.classList.contains("on-paper");
// Of a curve: those that the dark would hide are turned round.
const DARK_COLORS = {"#000000": "#ffffff", "#57606e": "#b4bcc8", "#0072b2": "#3d9ad6"};
const shown = (color) => (isDark() ? DARK_COLORS[color] ?? color : color);
const FONT = '12px system-ui, "Segoe UI", Roboto, Arial, "DejaVu Sans", sans-serif';

const element = (tag, kind, text = "") => {
  const made = document.createElement(tag);
  made.className = kind;
  made.textContent = text;
  return made;
};

// A faded curve is thin and pale until it is asked for or pointed at.
const isPale = (curve) => curve.is_faded && !curve.isAsked && !curve.isPointedAt;
const strokeOf = (curve) => (isPale(curve) ? `${shown(curve.color)}4d` : shown(curve.color));
const widthOf = (curve, width) => (isPale(curve) ? 1 : width);

const withUnit = (name, unit) => (unit ? `${name} [${unit}]` : name);

// Writes numbers with the decimals that suit the largest of them.
const formatterFor = (lists) => {
  let largest = 0;
  for (const list of lists) for (const value of list) largest = Math.max(largest, Math.abs(value ?? 0));
  const decimals = largest > 0 ? Math.min(Math.max(3 - Math.floor(Math.log10(largest)), 0), 9) : 0;
  return (value) => (value == null ? "–" : value.toFixed(decimals).replace("-", "−"));
};
