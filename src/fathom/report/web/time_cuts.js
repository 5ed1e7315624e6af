"use strict";
// A time axis on which long silences are cut out: runs with minutes of nothing between them stand next
// to one another. A time has a place on the axis; both count in seconds and are equal before the first
// cut.

const SILENT_SHARE = 1 / 3;  // of the whole span; with less silence nothing is cut
const BREAKS_SHARE = 0.2;    // of the time that is left: the width of all breaks together, at most

// The stretches of time [from, to] in which any of the panels has a value, in order, merged.
const stretchesOf = (panels) => {
  const stretches = [];
  for (const panel of panels) {
    const curves = [...(panel.measured ? [panel.measured] : []), ...panel.responses];
    let current = null;
    panel.time.forEach((time, i) => {
      if (!curves.some(({values}) => values[i] != null)) {
        current = null;
      } else if (current) {
        current[1] = time;
      } else {
        stretches.push(current = [time, time]);
      }
    });
  }
  stretches.sort((one, other) => one[0] - other[0]);
  const merged = [];
  for (const [from, to] of stretches) {
    const before = merged[merged.length - 1];
    if (before && from <= before[1]) before[1] = Math.max(before[1], to);
    else merged.push([from, to]);
  }
  return merged;
};

// The silences between them that are cut, {from, to, width}: each becomes a break so wide.
const cutsBetween = (stretches) => {
  const silences = stretches.slice(1).map(([from], i) => ({from: stretches[i][1], to: from}));
  const silent = silences.reduce((sum, {from, to}) => sum + to - from, 0);
  const whole = silences.length ? stretches[stretches.length - 1][1] - stretches[0][0] : 0;
  if (!(silent > SILENT_SHARE * whole)) return [];
  const width = BREAKS_SHARE * (whole - silent) / Math.max(silences.length, 10);
  return silences.filter(({from, to}) => to - from > width).map((silence) => ({...silence, width}));
};

// Inside of a break the place runs evenly.
const placeOf = (cuts, time) => {
  let place = time;
  for (const {from, to, width} of cuts) {
    place -= (to - from - width) * Math.min(Math.max((time - from) / (to - from), 0), 1);
  }
  return place;
};
const timeOf = (cuts, place) => {
  let time = place;
  for (const {from, to, width} of cuts) {
    if (time > from) time += (to - from - width) * Math.min((time - from) / width, 1);
  }
  return time;
};

// Round times between the places, about `step` apart and each stretch with one where there is room.
const roundTimes = (cuts, [min, max], step) => {
  const edges = [timeOf(cuts, min), ...cuts.flatMap(({from, to}) => [from, to]), timeOf(cuts, max)];
  const times = [];
  for (let i = 0; i < edges.length; i += 2) {
    const from = Math.max(edges[i], edges[0]);
    const to = Math.min(edges[i + 1], edges[edges.length - 1]);
    if (!(from < to)) continue;
    let fine = step;
    while (Math.ceil(from / fine) * fine > to) fine /= 10;
    const most = fine === step ? Infinity : 1;
    for (let k = Math.ceil(from / fine), n = 0; k * fine <= to && n < most; ++k, ++n) {
      const time = Number((k * fine).toPrecision(12));
      const last = times[times.length - 1] ?? -Infinity;
      if (placeOf(cuts, time) - placeOf(cuts, last) > 0.7 * step) times.push(time);
    }
  }
  return times;
};
