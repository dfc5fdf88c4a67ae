// SPDX-License-Identifier: Apache-2.0
// First section: what the edit changed, and what that did to the mesh.
import { el, integer, percent, section, short, table } from "./dom.js";
import { groupsTable } from "./groups.js";

const WAYS = {
  unchanged: "No surface moved: the mesh is that of the parent.",
  morphed: "The connectivity stayed; nodes near moved surfaces followed them.",
  local: "Only what changed was meshed anew, in a patch cut out of the parent's mesh.",
  full: "Every node was optimised anew, copied ones included.",
  fresh: "A regular mesh from new nodes.",
  TetGen: "TetGen's mesh of a conforming surface of the whole part, cleaned up.",
  renewed: "A regular mesh: the quality had drifted along the chain of edits.",
};

function wayOf(side) {
  if (side.way === "local" && side.parent === "") return "First mesh: all of it is new.";
  return WAYS[side.way] ?? "";
}

/** A change in words; what a value was and is stands apart from its name. */
function change(words) {
  const assigned = words.match(/^(size \S+|\S+) (.+) -> (.+)$/);
  if (!assigned) return el("li", {}, words);
  const [, name, was, is] = assigned;
  return el(
    "li",
    {},
    el("code", {}, name),
    " ",
    el("s", { "aria-label": `was ${was}` }, was),
    el("span", { "aria-hidden": "true" }, " → "),
    el("b", {}, is),
  );
}

function modelChanges(report) {
  if (!report.base) {
    return report.modified.parent
      ? el(
          "p",
          {},
          "The parent of this revision is not there any more, so nothing can be compared.",
        )
      : el("p", {}, "A first mesh: there is no revision before it to compare with.");
  }
  if (report.changes.length === 0) return el("p", {}, "Nothing differs in the two models.");
  return el("ul", { class: "changes" }, report.changes.map(change));
}

/** A bar of kept, moved and new, with its figures in words below. */
function share(title, counts, baseCount) {
  const all = counts.kept + counts.moved + counts.new;
  const parts = [
    ["kept", counts.kept],
    ["moved", counts.moved],
    ["new", counts.new],
  ];
  return el(
    "div",
    { class: "share" },
    el("h3", {}, title, " ", el("span", {}, integer(all))),
    el(
      "div",
      { class: "bar", "aria-hidden": "true" },
      parts.map(([name, count]) => el("i", { class: name, style: `flex-grow: ${count}` })),
    ),
    el(
      "dl",
      {},
      parts.map(([name, count]) =>
        el(
          "div",
          {},
          el("dt", {}, el("i", { class: `key ${name}` }), name),
          el("dd", {}, el("b", {}, percent(count, all)), ` ${integer(count)}`),
        ),
      ),
    ),
    el("p", { class: "note" }, `${integer(counts.gone)} of BASE’s ${integer(baseCount)} are gone.`),
  );
}

/** Cells of nodes and of tets, or a sentence where they cannot be compared. */
function shares(report) {
  if (!report.base) return [];
  if (report.descent === "none")
    return [
      el(
        "p",
        { class: "problem" },
        "NEW does not come from BASE by edits, so that no node or tet of one is one of the other’s.",
      ),
    ];
  const { nodes, tets } = report.counts;
  return [
    share("Nodes", nodes, report.base.mesh.nodes),
    share("Tets", tets, report.base.mesh.tets),
  ];
}

const SEVERAL =
  "Several edits lie between BASE and NEW: what has the same permanent id is the same; a node at " +
  "another place counts as moved, also where it moved with its feature.";

/** What was tried before the mesh that was taken; null where nothing was. */
function attempts({ report }) {
  if (!report || report.attempts.length === 0) return null;
  const taken = report.diagnostics?.taken;
  const seconds = (value) => (value > 0 ? short(value, 3) : "–");
  const rows = report.attempts.map((attempt) => [
    attempt.strategy,
    "given up",
    seconds(attempt.seconds),
    attempt.reason,
  ]);
  rows.push([taken?.strategy || "this mesh", "taken", seconds(taken?.seconds ?? 0), "–"]);
  return table(
    "Strategies in the order tried",
    [
      { title: "Strategy" },
      { title: "Outcome" },
      { title: "Seconds", number: true },
      { title: "Reason" },
    ],
    rows,
  );
}

function way(side) {
  if (!side.report) return el("p", {}, "The Report of this revision is not kept any more.");
  const repaired =
    side.report.last_resort_share > 0
      ? el(
          "p",
          { class: "note" },
          `${percent(side.report.last_resort_share, 1)} of the tets were made anew where the mesh was wrong.`,
        )
      : null;
  return [
    el("p", {}, el("strong", { class: "way" }, side.way), " ", wayOf(side)),
    repaired,
    side.report.attempts.length === 0
      ? el("p", { class: "note" }, "No other strategy was tried.")
      : null,
  ];
}

function warnings(side) {
  const list = side.report?.warnings ?? [];
  if (list.length === 0) return el("p", { class: "note" }, "None.");
  return el(
    "ul",
    { class: "warnings" },
    list.map(({ code, message }) => el("li", {}, el("code", {}, code), " ", message)),
  );
}

/** What both meshes are like, a row each figure. */
function comparison(sides) {
  const of = (side, pick) => (side.report ? pick(side.report) : "–");
  const unit = sides.at(-1).unit;
  const rows = [
    ["Nodes", (side) => integer(side.mesh.nodes)],
    ["Tets", (side) => integer(side.mesh.tets)],
    ["Boundary facets", (side) => integer(side.mesh.facets)],
    ["Order of the tets", (side) => of(side, (r) => String(r.order || 1))],
    [
      `Target edge length${unit ? ` (${unit})` : ""}`,
      (side) => of(side, (r) => short(r.edge_length)),
    ],
    ["Volume of the mesh", (side) => of(side, (r) => short(r.volume, 7))],
    ["Volume of the model", (side) => of(side, (r) => short(r.exact_volume, 7))],
    ["Volume-length, mean", (side) => of(side, (r) => short(r.quality.volume_length_mean, 3))],
    [
      "Volume-length, 1st percentile",
      (side) => of(side, (r) => short(r.quality.volume_length_p01, 3)),
    ],
    ["Volume-length, least", (side) => of(side, (r) => short(r.quality.volume_length_min, 3))],
    ["Dihedral angle, least", (side) => of(side, (r) => `${short(r.quality.dihedral_min, 3)}°`)],
    ["Dihedral angle, largest", (side) => of(side, (r) => `${short(r.quality.dihedral_max, 4)}°`)],
    [
      "Distance of chords from the model, most",
      (side) => of(side, (r) => short(r.verification.chord_error, 3)),
    ],
    ["Seconds", (side) => of(side, (r) => short(r.seconds.total, 3))],
  ];
  const heads = [
    { title: "Figure" },
    ...sides.map((side, k) => ({
      title: sides.length === 1 ? side.name : k === 0 ? `BASE ${side.name}` : `NEW ${side.name}`,
      number: true,
    })),
  ];
  return table(
    "Figures of the meshes",
    heads,
    rows.map(([name, pick]) => [name, ...sides.map(pick)]),
  );
}

export function changesSection(report, sides) {
  const side = report.modified;
  return section(
    "changes",
    report.base ? "What changed" : "What it is",
    el(
      "div",
      { class: "columns" },
      el("div", {}, el("h3", {}, "Model"), modelChanges(report)),
      shares(report),
    ),
    report.descent === "ancestor" ? el("p", { class: "note" }, SEVERAL) : null,
    el(
      "div",
      { class: "columns" },
      el("div", {}, el("h3", {}, "How the mesh was made"), way(side)),
      el("div", {}, el("h3", {}, "Warnings"), warnings(side)),
    ),
    attempts(side),
    comparison(sides),
    groupsTable(report),
  );
}
