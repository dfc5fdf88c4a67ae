// SPDX-License-Identifier: Apache-2.0
// Colours of the page, which follow the browser's light or dark scheme; paper is light.

const NAMES = [
  "ink",
  "muted",
  "line",
  "page",
  "card",
  "neutral",
  "kept",
  "moved",
  "new",
  "gone",
  "base-series",
  "modified-series",
  "edge",
  "alarm",
];

/** The colours in force, by name. */
export function theme() {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]),
  );
}

/** Calls `redraw` whenever what is drawn on a canvas has to take other colours. */
export function onThemeChange(redraw) {
  const root = document.documentElement;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  addEventListener("beforeprint", () => {
    root.classList.add("on-paper");
    redraw();
  });
  addEventListener("afterprint", () => {
    root.classList.remove("on-paper");
    redraw();
  });
}
