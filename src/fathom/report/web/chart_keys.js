"use strict";
// The keys of a chart over time: + and - zoom about the middle, arrows move, 0 and Escape reset.

// The stretch of this width about this middle, moved and cut so that it lies within the whole.
const fittingStretch = (middle, width, [first, last]) => {
  const fitting = Math.min(Math.max(width, 1e-4 * (last - first)), last - first);
  const from = Math.min(Math.max(middle - fitting / 2, first), last - fitting);
  return [from, from + fitting];
};

// The stretch that a key makes of the one that is shown, within the whole; null: it is no key of ours.
const stretchAfter = (key, [min, max], [first, last]) => {
  const stretch = (middle, width) => fittingStretch(middle, width, [first, last]);
  const middle = (min + max) / 2;
  const width = max - min;
  switch (key) {
    case "+": case "=": return stretch(middle, width / 2);
    case "-": return stretch(middle, width * 2);
    case "ArrowLeft": return stretch(middle - width / 4, width);
    case "ArrowRight": return stretch(middle + width / 4, width);
    case "0": case "Escape": return [first, last];
    default: return null;
  }
};

// The frame of a chart takes the focus and the keys.
const listenToKeys = (frame, group, name) => {
  frame.tabIndex = 0;
  frame.setAttribute("role", "group");
  frame.setAttribute("aria-label", `${name}: + and - zoom, arrows move, 0 resets`);
  frame.addEventListener("keydown", (event) => {
    if (event.target !== frame || event.ctrlKey || event.altKey || event.metaKey) return;
    const {min, max} = group.plots[0].scales.x;
    const stretch = stretchAfter(event.key, [min, max], [group.first, group.last]);
    if (!stretch) return;
    event.preventDefault();
    group.zoom(...stretch);
  });
};
