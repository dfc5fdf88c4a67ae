// SPDX-License-Identifier: Apache-2.0
// The table of groups: what loads and supports hang on, before and after.
import { el, integer, short, table } from "./dom.js";

const STATES = {
  STATE_SAME: "same",
  STATE_RESIZED: "resized",
  STATE_SPLIT: "split",
  STATE_MERGED: "merged",
  STATE_EMPTIED: "emptied",
  STATE_NEW: "new",
};

const area = (value) => (value > 0 ? short(value, 5) : "–");

/** Those that are not as they were come first, else as the Report has them. */
function inOrder(groups) {
  const isSame = ({ state }) => state === "STATE_SAME";
  return [...groups.filter((group) => !isSame(group)), ...groups.filter(isSame)];
}

export function groupsTable(report) {
  const groups = report.modified.report?.groups ?? [];
  if (groups.length === 0) return null;
  const before = new Map((report.base?.report?.groups ?? []).map((group) => [group.group, group]));
  const hasBase = report.base !== null;
  const pair = (group, pick) => {
    const was = before.get(group.group);
    const is = pick(group);
    if (!hasBase || !was || pick(was) === is) return is;
    return [el("span", { class: "was" }, pick(was), " → "), is];
  };
  const rows = inOrder(groups).map((group) => [
    el("code", {}, group.group.replaceAll("+", " + ")),
    el("span", { class: `state ${STATES[group.state] ?? "none"}` }, STATES[group.state] ?? "–"),
    pair(group, (g) => area(g.exact_area)),
    pair(group, (g) => area(g.mesh_area)),
    pair(group, (g) => integer(g.facets)),
    pair(group, (g) => integer(g.nodes)),
    pair(group, (g) => (g.tets > 0 ? integer(g.tets) : "–")),
  ]);
  const changed = groups.filter(({ state }) => STATES[state] && state !== "STATE_SAME").length;
  const isCompared = groups.some(({ state }) => STATES[state]);
  const caption =
    `Groups: ${integer(groups.length)}` +
    (isCompared ? `, ${integer(changed)} of them not as they were in the parent` : "");
  return table(
    caption,
    [
      { title: "Group" },
      { title: "State" },
      { title: "Exact area", number: true },
      { title: "Area of the mesh", number: true },
      { title: "Facets", number: true },
      { title: "Nodes", number: true },
      { title: "Tets", number: true },
    ],
    rows,
    { class: "long" },
  );
}
