// SPDX-License-Identifier: Apache-2.0
// The panel beside the meshes and the legend of the colours in force.
import GUI from "lil-gui";
import { css, rampAsGradient } from "./colours.js";
import { el } from "./dom.js";
import { theme } from "./theme.js";

const AXES = ["x", "y", "z"];

/** Ends, middle and step of the plane's way along an axis, in the model's coordinates. */
function range(viewer, centre, axis) {
  const low = viewer.box.min.getComponent(axis) + centre[axis];
  const high = viewer.box.max.getComponent(axis) + centre[axis];
  const step = (high - low) / 200;
  const middle = (low + high) / 2;
  return { low, high, middle: Math.abs(middle) < step / 1000 ? 0 : middle, step };
}

/** Which half stays where nothing else is asked for: the one behind the plane, seen from the camera. */
function farHalf(viewer, axis, position) {
  return viewer.shared.camera.position.getComponent(axis) > position ? 1 : -1;
}

function addPlane(gui, viewer, centre, unit) {
  const state = { on: false, axis: "y", position: range(viewer, centre, 1).middle, flip: false };
  let half = 1;
  const apply = () => {
    const axis = AXES.indexOf(state.axis),
      position = state.position - centre[axis];
    viewer.set({ plane: state.on ? { axis, position, side: state.flip ? -half : half } : null });
  };
  const choose = () => {
    const axis = AXES.indexOf(state.axis);
    half = farHalf(viewer, axis, state.position - centre[axis]);
    apply();
  };
  const folder = gui.addFolder("Cutting plane");
  const on = folder.add(state, "on").name("Cut").onChange(choose);
  const toMiddle = () => {
    const { low, high, middle, step } = range(viewer, centre, AXES.indexOf(state.axis));
    state.position = middle;
    position.min(low).max(high).step(step).updateDisplay();
    choose();
  };
  const across = folder.add(state, "axis", AXES).name("Across").onChange(toMiddle);
  const { low, high, step } = range(viewer, centre, 1);
  const position = folder
    .add(state, "position", low, high, step)
    .decimals(2)
    .name(unit ? `At (${unit})` : "At")
    .onChange(() => {
      if (state.on) return apply();
      state.on = true;
      on.updateDisplay();
      choose();
    });
  folder.add(state, "flip").name("Other half").onChange(apply);
  return {
    cut: (axis) => {
      Object.assign(state, { on: true, axis });
      for (const controller of [on, across]) controller.updateDisplay();
      toMiddle();
    },
  };
}

/** What each colour means; a category can be picked out, so that no colour has to be told by eye. */
function legend(viewer) {
  const mode = viewer.modes[viewer.settings.mode];
  if (mode.range)
    return [
      el("p", { class: "legend-title" }, mode.title, el("small", {}, ` – ${mode.more}`)),
      el("div", {
        class: "ramp",
        style: `background: ${rampAsGradient()}`,
        role: "img",
        "aria-label": `Dark ${mode.range[0]}, light ${mode.range[1]}`,
      }),
      el(
        "div",
        { class: "ramp-ends" },
        el("span", {}, mode.range[0]),
        el("span", {}, mode.range[1]),
      ),
    ];
  const colours = theme();
  return [
    el("p", { class: "legend-title" }, mode.title, el("small", {}, " – press one to pick it out")),
    el(
      "ul",
      {},
      mode.keys.map(({ key, text }) =>
        el(
          "li",
          {},
          el(
            "button",
            {
              type: "button",
              "aria-pressed": String(viewer.settings.lit === key),
              onclick: () => viewer.set({ lit: viewer.settings.lit === key ? null : key }),
            },
            el("i", { style: `background: ${css(mode.colour(key, colours))}` }),
            text,
          ),
        ),
      ),
    ),
  ];
}

/** The panel, with the legend below it; the legend is written again with whatever changes it. */
export function controls(viewer, report) {
  const place = el("div", { class: "panel" });
  const key = el("div", { class: "legend", "aria-live": "polite" });
  const gui = new GUI({ container: place, title: "View", width: 0 });
  const state = {
    mode: viewer.settings.mode,
    layout: "both",
    edges: true,
    reset: () => {
      viewer.setFocus(null);
      viewer.shared.reset();
    },
  };
  const modes = gui
    .add(
      state,
      "mode",
      Object.fromEntries(Object.entries(viewer.modes).map(([name, { title }]) => [title, name])),
    )
    .name("Colour by")
    .onChange((mode) => viewer.set({ mode }));
  const layouts = gui
    .add(state, "layout", { "Side by side": "both", "BASE alone": "base", "NEW alone": "modified" })
    .name("Meshes")
    .onChange((layout) => viewer.set({ layout }));
  layouts.show(viewer.views.length > 1);
  gui
    .add(state, "edges")
    .name("Edges")
    .onChange((edges) => viewer.set({ edges }));
  const plane = report.surfaces_only
    ? null
    : addPlane(gui, viewer, report.centre, report.modified.unit);
  gui.add(state, "reset").name("Show all");
  const set = viewer.set.bind(viewer);
  viewer.set = (changes) => {
    set(changes);
    for (const [name, controller] of [
      ["layout", layouts],
      ["mode", modes],
    ]) {
      if (!(name in changes)) continue;
      state[name] = changes[name];
      controller.updateDisplay();
    }
    if ("mode" in changes || "lit" in changes) key.replaceChildren(...legend(viewer));
  };
  viewer.updateLegend = () => key.replaceChildren(...legend(viewer));
  viewer.updateLegend();
  return { panel: place, legend: key, plane };
}
