// SPDX-License-Identifier: Apache-2.0
// Seconds by phase: a bar each revision on one scale, and the same in a table.
import { css, category } from "./colours.js";
import { el, section, short, table } from "./dom.js";

const PHASES = [
  ["Setup", "cellular model, membership, samples", (s) => s.setup],
  ["Difference", "classes, order of copying", (s) => s.difference],
  ["Copy", "copying, new nodes, free and fixed", (s) => s.copy],
  ["Optimise", "the loop", (s) => s.optimise],
  ["Extract", "peel, clean-up, groups, maps", (s) => Math.max(0, s.extract - s.verify)],
  ["Verify", "of the mesh that is handed out", (s) => s.verify],
];

const inSeconds = (value) => (value > 0 && value < 0.001 ? "< 0.001" : short(value, 3));

function phasesOf({ seconds }) {
  const phases = PHASES.map(([, , pick]) => pick(seconds));
  const rest = seconds.total - phases.reduce((sum, value) => sum + value, 0);
  return [...phases, Math.max(0, rest)];
}

export function secondsSection(sides) {
  const timed = sides.filter((side) => side.report);
  if (timed.length === 0) return null;
  const names = [...PHASES.map(([name]) => name), "Other"];
  const most = Math.max(...timed.map((side) => side.report.seconds.total)) || 1;
  const label = (side) =>
    sides.length === 1 ? side.name : side === sides[0] ? `BASE ${side.name}` : `NEW ${side.name}`;
  const bars = timed.map((side) =>
    el(
      "div",
      { class: "time" },
      el("span", { class: "time-name" }, label(side)),
      el(
        "div",
        { class: "time-bar" },
        el(
          "div",
          {
            class: "bar",
            "aria-hidden": "true",
            style: `width: ${(100 * side.report.seconds.total) / most}%`,
          },
          phasesOf(side.report).map((value, k) =>
            el("i", {
              style: `flex-grow: ${value}; background: ${css(category(k))}`,
              title: `${names[k]} ${short(value, 3)} s`,
            }),
          ),
        ),
      ),
      el("b", {}, `${short(side.report.seconds.total, 3)} s`),
    ),
  );
  const rows = names
    .map((name, k) => [
      [
        el("i", { class: "key", style: `background: ${css(category(k))}` }),
        name,
        " ",
        el("small", {}, PHASES[k]?.[1] ?? "what lies between the phases"),
      ],
      ...timed.map((side) => inSeconds(phasesOf(side.report)[k])),
    ])
    .filter((_, k) => k < PHASES.length || timed.some((side) => phasesOf(side.report)[k] >= 0.001));
  return section(
    "seconds",
    "Time",
    ...bars,
    table(
      "Seconds by phase",
      [{ title: "Phase" }, ...timed.map((side) => ({ title: label(side), number: true }))],
      rows,
    ),
  );
}
