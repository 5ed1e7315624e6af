// Fills the empty places of the archive page.
const data = JSON.parse(document.getElementById("data").textContent);
const readAfter = performance.now();  // [ms]
const place = (id) => document.getElementById(id);
showParameterCharts(place("parameter-charts"), data.parameters, data.archive.dives);
showEffectMatrices(place("effect-matrices"), data.archive.dives);
showDiveTable(place("dive-table"), data.archive);
showDiveComparison(place("dive-comparison"), data);
const drawnAfter = (document.body.offsetHeight, performance.now());  // [ms], laid out as well
if (location.hash === "#selftest") testYourself(readAfter, drawnAfter);
