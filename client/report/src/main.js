// SPDX-License-Identifier: Apache-2.0
// The page of `remesh report`: reads what the command wrote into it and shows it.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { changesSection } from "./changes.js";
import { colourModes } from "./colours.js";
import { controls } from "./controls.js";
import { readReport, sidesOf } from "./data.js";
import { el, integer, section } from "./dom.js";
import { histogramsSection } from "./histograms.js";
import { libraries } from "./libraries.js";
import { secondsSection } from "./seconds.js";
import { onThemeChange } from "./theme.js";
import { Viewer } from "./viewer.js";
import { worstSection } from "./worst.js";

function header({ base, modified, counts, descent }) {
  const kept =
    base && descent !== "none" && counts.tets.kept + counts.tets.moved + counts.tets.new > 0
      ? ` ${((100 * counts.tets.kept) / modified.mesh.tets).toFixed(0)} % of its tets were kept from ${base.name}.`
      : "";
  const made = modified.created.startsWith("1970")
    ? ""
    : `, ${modified.created.replace("T", " ").replace(/\.\d+/, "").replace("Z", " UTC")}`;
  const names = base
    ? [
        el("span", {}, base.name),
        el("span", { class: "arrow", "aria-label": "to" }, "→"),
        el("span", {}, modified.name),
      ]
    : [modified.name];
  return el(
    "header",
    {},
    el("p", { class: "kind" }, base ? "Report of an edit" : "Report of a mesh"),
    el("h1", {}, names),
    el(
      "p",
      { class: "lead" },
      `${modified.model || modified.name}: ${integer(modified.mesh.nodes)} nodes and ${integer(modified.mesh.tets)} tets.${kept}`,
    ),
    el(
      "p",
      { class: "ids" },
      base ? ["BASE ", el("code", {}, base.id.slice(0, 12)), "  NEW "] : "Revision ",
      el("code", {}, modified.id.slice(0, 12)),
      made,
    ),
  );
}

const KEYS =
  "Drag to turn, right button to move, wheel to zoom; two fingers move and zoom. With the picture in focus: arrow keys turn, + and − zoom, 0 shows all, Escape leaves a tet.";

/** The meshes in 3-D; without WebGL a sentence in their place. */
function meshesSection(report, sides) {
  const surfaces = report.surfaces_only
    ? el(
        "p",
        { class: "note" },
        `Only the surfaces and the worst tets are in this page: the interior was left out, as it is above ${integer(report.most_tets_inside)} tets or where that was asked for. There is no cutting plane.`,
      )
    : null;
  const curved = sides.some((side) => side.report?.order === 2)
    ? el("p", { class: "note" }, "Tets of second order are drawn with straight edges.")
    : null;
  try {
    const viewer = new Viewer(sides, colourModes(sides));
    const { panel, legend, plane } = controls(viewer, report);
    viewer.plane = plane;
    return {
      viewer,
      element: section(
        "meshes",
        sides.length > 1 ? "Meshes" : "Mesh",
        surfaces,
        curved,
        el("div", { class: "viewer" }, viewer.frame, panel, legend),
        el("p", { class: "note keys", id: "viewer-keys" }, KEYS),
      ),
    };
  } catch (error) {
    console.warn(error);
    return {
      viewer: null,
      element: section(
        "meshes",
        "Meshes",
        el(
          "p",
          { class: "problem" },
          `The meshes cannot be drawn: this browser gives the page no WebGL (${error.message}).`,
        ),
      ),
    };
  }
}

function footer(version) {
  return el(
    "footer",
    {},
    el(
      "p",
      {},
      `Written by remesh ${version}. The page is whole: it loads nothing, and what it shows stays in it.`,
    ),
    el(
      "p",
      {},
      "Drawn with ",
      libraries.map(({ name, use }, k) => [k ? ", " : "", el("b", {}, name), ` (${use})`]),
      ", all under the MIT licence.",
    ),
    el(
      "details",
      {},
      el("summary", {}, "Licences"),
      el("p", {}, "The page’s own script and style are part of remeshd, Apache-2.0."),
      libraries.map(({ name, licence }) => [el("h3", {}, name), el("pre", {}, licence)]),
    ),
  );
}

async function show() {
  const report = await readReport();
  const sides = sidesOf(report);
  const { viewer, element: meshes } = meshesSection(report, sides);
  const histograms = histogramsSection(sides);
  document
    .getElementById("report")
    .replaceChildren(
      ...[
        header(report),
        changesSection(report, sides),
        meshes,
        histograms.element,
        secondsSection(sides),
        worstSection(report, sides, viewer),
        footer(report.version),
      ].filter(Boolean),
    );
  histograms.redraw();
  viewer?.resize();
  onThemeChange(() => {
    viewer?.repaint();
    viewer?.updateLegend();
    viewer?.render(); // at once: paper does not wait for the next frame
    histograms.redraw();
  });
  openAsAsked(report, sides, viewer);
  document.documentElement.dataset.state = "ready";
}

/** `#colour=quality&cut=y&worst=1` in the address opens the page so: for links to a view. */
function openAsAsked(report, sides, viewer) {
  const asked = new URLSearchParams(location.hash.slice(1));
  if (!viewer) return;
  if (viewer.modes[asked.get("colour")]) viewer.set({ mode: asked.get("colour") });
  if (["x", "y", "z"].includes(asked.get("cut"))) viewer.plane?.cut(asked.get("cut"));
  const worst = report.modified.mesh.worst[Number(asked.get("worst")) - 1];
  if (worst) viewer.setFocus(worst, sides.length - 1, report.centre);
}

show().catch((error) => {
  document.documentElement.dataset.state = "failed";
  document
    .getElementById("report")
    .replaceChildren(
      el(
        "p",
        { class: "problem", role: "alert" },
        `This page cannot be shown: ${error.message}. It needs a browser of 2023 or later.`,
      ),
    );
  console.error(error);
});
