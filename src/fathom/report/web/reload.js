"use strict";
// A page that is written anew while its data grow loads itself again: also from file://, where a
// browser lets no script read a file. It stands still while a reader zooms or holds a button.
const reloadWhileItGrows = (groups) => {
  const seconds = Number(document.querySelector("main").dataset.reload ?? 0);
  if (!(seconds > 0)) return;
  let isHeld = false;
  window.addEventListener("pointerdown", () => { isHeld = true; });
  window.addEventListener("pointerup", () => { isHeld = false; });
  window.addEventListener("pointercancel", () => { isHeld = false; });
  setInterval(() => {
    if (!isHeld && !document.hidden && !groups.some((group) => group.isZoomed)) location.reload();
  }, 1000 * seconds);
};
