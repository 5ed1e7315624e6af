"use strict";
// The fingers on a chart over time: two zoom, one moves. A finger that moves up or down scrolls the page.

// The stretch that fingers make of the one that they touched, [min, max] over so many px: what was under
// each of them stays there. A finger is {from, to} [px]; two at most count.
const stretchByFingers = (fingers, size, [min, max], whole) => {
  const perPixel = (max - min) / size;
  const [one, other] = fingers;
  const isPinch = other && Math.abs(other.to - one.to) > 1 && Math.sign(other.to - one.to) === Math.sign(other.from - one.from);
  const scale = isPinch ? (perPixel * (other.from - one.from)) / (other.to - one.to) : perPixel;
  const from = min + perPixel * one.from - scale * one.to;
  return fittingStretch(from + (scale * size) / 2, scale * size, whole);
};

const listenToFingers = (plot, group) => {
  const {over} = plot;
  const fingers = new Map();
  let touched = null;
  const placeIn = (event) => event.clientX - over.getBoundingClientRect().left;
  // What is shown now is what the fingers have touched from now on.
  const begin = () => {
    for (const finger of fingers.values()) finger.from = finger.to;
    touched = [plot.scales.x.min, plot.scales.x.max];
  };
  over.addEventListener("pointerdown", (event) => {
    if (event.pointerType !== "touch") return;
    fingers.set(event.pointerId, {to: placeIn(event)});
    begin();
  });
  over.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId)) return;
    fingers.get(event.pointerId).to = placeIn(event);
    group.zoom(...stretchByFingers([...fingers.values()], over.clientWidth, touched, [group.first, group.last]));
  });
  for (const end of ["pointerup", "pointercancel"]) {
    over.addEventListener(end, (event) => {
      if (fingers.delete(event.pointerId)) begin();
    });
  }
};
