// SPDX-License-Identifier: Apache-2.0
// The worst tets of each mesh; a press shows where one lies.
import { STATES } from "./data.js";
import { el, integer, section, short, table } from "./dom.js";

function list(side, title, show) {
  const rows = side.mesh.worst.map((worst, k) => {
    const middle = [0, 1, 2].map((axis) => worst.corners.reduce((sum, c) => sum + c[axis], 0) / 4);
    const name = `Tet ${integer(worst.tet)}`;
    return [
      show
        ? el(
            "button",
            {
              type: "button",
              class: "fly",
              "aria-label": `Show tet ${worst.tet} of ${side.name}, number ${k + 1} of the worst`,
              onclick: (event) => show(worst, event.currentTarget),
            },
            name,
          )
        : name,
      worst.quality.toFixed(3),
      `${worst.least_angle.toFixed(1)}°`,
      `${worst.largest_angle.toFixed(1)}°`,
      STATES[worst.state],
      side.mesh.cell_owners[worst.cell]?.at(-1) ?? "–",
      middle.map((value) => short(value, 4)).join(", "),
    ];
  });
  return table(
    title,
    [
      { title: "Tet" },
      { title: "Volume-length", number: true },
      { title: "Least angle", number: true },
      { title: "Largest angle", number: true },
      { title: "State" },
      { title: "Feature" },
      { title: "Centroid", number: true },
    ],
    rows,
  );
}

const unmark = () =>
  document
    .querySelectorAll(".fly[aria-current]")
    .forEach((button) => button.removeAttribute("aria-current"));

export function worstSection(report, sides, viewer) {
  if (viewer) viewer.onFocus = (isOn) => isOn || unmark();
  const lists = sides
    .map((side, number) => {
      const title =
        sides.length === 1
          ? "The worst ten"
          : `The worst ten of ${number === 0 ? "BASE" : "NEW"} ${side.name}`;
      const show =
        viewer &&
        ((worst, button) => {
          unmark();
          button.setAttribute("aria-current", "true");
          viewer.setFocus(worst, number, report.centre);
          document
            .getElementById("meshes")
            .scrollIntoView({
              block: "start",
              behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth",
            });
          viewer.canvas.focus({ preventScroll: true });
        });
      return list(side, title, show);
    })
    .reverse();
  return section(
    "worst",
    "Worst tets",
    viewer
      ? el(
          "p",
          { class: "hint" },
          "Press a tet to fly there. It is shown through the others; Escape shows all again.",
        )
      : null,
    el("div", { class: "pair" }, lists),
  );
}
