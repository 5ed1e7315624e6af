"use strict";
// One button for each curve: shows and hides it, or brings out a faded one and fades it again. It reads
// out its value below the cursor.
const makeLegend = (group, panel, curves) => {
  const hasNotes = curves.some((curve) => curve.note);
  const legend = element("div", hasNotes ? "legend" : "legend one-line");
  // A stamp is told from the next one.
  const step = (panel.time[panel.time.length - 1] - panel.time[0]) / (panel.time.length - 1) || 1;
  const timeDecimals = Math.min(Math.max(Math.ceil(-Math.log10(step) - 0.01), 0), 5);
  const time = element("span", "time-read-out");
  const buttons = curves.map((curve) => {
    const button = element("button", "");
    button.type = "button";
    button.classList.toggle("faded", curve.is_faded);
    button.setAttribute("aria-pressed", String(!curve.is_faded));
    button.title = curve.is_faded ? "Bring out or fade" : "Show or hide";
    const swatch = element("span", "swatch");
    swatch.style.background = shown(curve.color);
    swatch.dataset.color = curve.color;
    const name = element("span", "key-name", curve.name);
    // Until the cursor is in the chart the place of the value tells something else.
    const atRest = curve.note || (hasNotes && curve === curves[0] ? "hover to read values" : "");
    const readOut = element("span", "read-out", atRest);
    button.append(swatch, name, readOut);
    button.addEventListener("click", () => {
      const show = button.getAttribute("aria-pressed") === "false";
      button.setAttribute("aria-pressed", String(show));
      if (curve.is_faded) {
        curve.isAsked = show;
        repaint(curve);
        return;
      }
      for (const [plot, index] of [...curve.drawn, ...(curve.edges ?? [])]) plot.setSeries(index, {show});
    });
    const point = (isPointedAt) => {
      curve.isPointedAt = isPointedAt;
      if (curve.is_faded) repaint(curve);
      for (const [plot, index] of curve.drawn) plot.setSeries(isPointedAt ? index : null, {focus: true});
    };
    button.addEventListener("mouseenter", () => point(true));
    button.addEventListener("mouseleave", () => point(false));
    button.addEventListener("focus", () => { if (button.matches(":focus-visible")) point(true); });
    button.addEventListener("blur", () => point(false));
    legend.append(button);
    return {readOut, curve, atRest};
  });
  const reset = element("button", "reset", "Reset zoom");
  reset.type = "button";
  reset.hidden = true;
  reset.addEventListener("click", () => group.zoom(group.first, group.last));
  group.onZoom.push((isZoomed) => { reset.hidden = !isZoomed; });
  legend.append(reset, time);

  const valueFormat = formatterFor(curves.map((curve) => curve.values));
  const residualFormat = formatterFor(curves.map((curve) => curve.residual ?? []));
  legend.update = (index) => {
    const isOutside = index == null;
    time.textContent = isOutside ? "" : `t = ${(panel.time[index] + panel.time_offset).toFixed(timeDecimals)} s`;
    for (const {readOut, curve, atRest} of buttons) {
      let text = atRest;
      if (!isOutside) {
        text = valueFormat(curve.values[index]);
        if (panel.unit) text += ` ${panel.unit}`;
        if (curve.residual) text += `  Δ ${residualFormat(curve.residual[index])}`;
      }
      readOut.textContent = text;
    }
  };
  return legend;
};
