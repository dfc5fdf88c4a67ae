// SPDX-License-Identifier: Apache-2.0
// What facets and tets can be coloured by. All palettes can be told apart by colour-blind readers.
import { STATES } from "./data.js";
import { short } from "./dom.js";

// Okabe and Ito, "Color universal design" (2008).
const CATEGORIES = [
  "#0072b2",
  "#e69f00",
  "#009e73",
  "#cc79a7",
  "#56b4e9",
  "#d55e00",
  "#f0e442",
  "#8c8c8c",
];
// Viridis, of matplotlib: lightness rises all along.
const RAMP = [
  "#440154",
  "#482878",
  "#3e4989",
  "#31688e",
  "#26828e",
  "#1f9e89",
  "#35b779",
  "#6ece58",
  "#b5de2b",
  "#fde725",
].map(parse);

export function parse(colour) {
  const number = parseInt(colour.slice(1), 16);
  return [(number >> 16) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
}

export function mix(a, b, share) {
  return a.map((value, k) => value + (b[k] - value) * share);
}

/** The eight colours, then lighter and darker ones. */
export function category(k) {
  const colour = parse(CATEGORIES[k % CATEGORIES.length]);
  const round = Math.floor(k / CATEGORIES.length) % 3;
  if (round === 0) return colour;
  return round === 1 ? mix(colour, [1, 1, 1], 0.5) : mix(colour, [0, 0, 0], 0.45);
}

export function ramp(share) {
  const at = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
  const k = Math.min(Math.floor(at), RAMP.length - 2);
  return mix(RAMP[k], RAMP[k + 1], at - k);
}

export const rampAsGradient = () =>
  `linear-gradient(to right, ${RAMP.map((c) => css(c)).join(", ")})`;

export function css(colour) {
  return `rgb(${colour.map((value) => Math.round(255 * value)).join(" ")})`;
}

const STATE_TEXTS = {
  kept: "Kept: four kept nodes that formed a tet",
  moved: "Moved: old nodes, at least one moved",
  new: "New: a new node, or joined anew",
  gone: "Of BASE: not kept",
};

function byState(sides) {
  const hasBase = sides.length > 1;
  const keys = ["kept", "moved", "new", "gone"].filter((key) => hasBase || key === "new");
  return {
    title: "Kept, moved, new",
    keys: keys.map((key) => ({
      key,
      text: hasBase ? STATE_TEXTS[key] : "New: all of a first mesh",
    })),
    colour: (key, theme) => parse(theme[key]),
    facet: (side, facet) => STATES[side.arrays.facet_state[facet]],
    tet: (side, tet) => STATES[side.arrays.tet_state[tet]],
  };
}

/** The last feature in history that owns a cell. */
const ownerOf = (side, cell) => side.mesh.cell_owners[cell]?.at(-1) ?? "(no feature)";

function categories(title, sides, labelsOf, facet, tet) {
  const labels = [...new Set(sides.flatMap(labelsOf))];
  const number = new Map(labels.map((label, k) => [label, k]));
  return {
    title,
    keys: labels.map((label) => ({ key: label, text: label })),
    colour: (key, theme) => (number.has(key) ? category(number.get(key)) : parse(theme.neutral)),
    facet,
    tet,
  };
}

const byFeature = (sides) =>
  categories(
    "Feature",
    sides,
    (side) => {
      const found = new Set(side.mesh.cell_owners.map((_, cell) => ownerOf(side, cell)));
      return side.features.filter((feature) => found.has(feature));
    },
    (side, facet) => ownerOf(side, side.arrays.facet_cell[facet]),
    (side, tet) => ownerOf(side, side.arrays.tet_cell[tet]),
  );

export const faceName = (side, group) => side.mesh.face_groups[group]?.join(" + ") ?? "(no face)";

const byFace = (sides) =>
  categories(
    "Face group",
    sides,
    (side) => side.mesh.face_groups.map((_, group) => faceName(side, group)),
    (side, facet) => faceName(side, side.arrays.facet_group[facet]),
    () => "(inside)",
  );

function byQuality(sides) {
  const least = Math.min(...sides.map((side) => side.mesh.worst[0]?.quality ?? 1));
  const low = Math.max(0, Math.floor(10 * least) / 10);
  const share = (quality) => (quality / 255 - low) / (1 - low);
  return {
    title: "Quality",
    more: "volume-length",
    range: [short(low, 2), "1 (regular tet)"],
    facetShare: (side, facet) => share(side.arrays.facet_quality[facet]),
    tetShare: (side, tet) => share(side.arrays.tet_quality[tet]),
  };
}

function bySize(sides) {
  const sized = sides.filter((side) => side.arrays.sizes);
  if (sized.length === 0) return null;
  let low = Infinity,
    high = -Infinity;
  for (const side of sized)
    for (const size of side.arrays.sizes) {
      low = Math.min(low, size);
      high = Math.max(high, size);
    }
  const span = Math.log(high / low) || 1;
  return {
    title: "Size asked for",
    more: "logarithmic",
    range: [short(low, 3), `${short(high, 3)} ${sides[0].unit}`],
    nodeShare: (side, node) =>
      side.arrays.sizes ? Math.log(side.arrays.sizes[node] / low) / span : 0,
  };
}

/** The modes that there are data for, by name, in the order of the menu. */
export function colourModes(sides) {
  const modes = {
    state: byState(sides),
    quality: byQuality(sides),
    feature: byFeature(sides),
    face: byFace(sides),
    size: bySize(sides),
  };
  return Object.fromEntries(Object.entries(modes).filter(([, mode]) => mode));
}

/**
 * The colours of the three corners of a face, written to `out` from `at` on. `facet`: of the
 * boundary, or -1; `tet`: of a face inside; `lit`: the key that alone is shown in colour, or null.
 */
export function paintFace(mode, side, facet, tet, nodes, palette, lit, out, at) {
  for (let k = 0; k < 3; ++k) {
    let colour;
    if (mode.nodeShare) colour = ramp(mode.nodeShare(side, nodes[k]));
    else if (mode.facetShare)
      colour = ramp(facet >= 0 ? mode.facetShare(side, facet) : mode.tetShare(side, tet));
    else {
      const key = facet >= 0 ? mode.facet(side, facet) : mode.tet(side, tet);
      colour = palette.of(key);
      if (lit !== null && key !== lit) colour = palette.dimmed;
    }
    out[at + 3 * k] = toLinear(colour[0]);
    out[at + 3 * k + 1] = toLinear(colour[1]);
    out[at + 3 * k + 2] = toLinear(colour[2]);
  }
}

/** sRGB to linear light, as the renderer takes colours. */
function toLinear(value) {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
