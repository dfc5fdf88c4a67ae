// SPDX-License-Identifier: Apache-2.0
// Faces of tets: which tets share one, and which are seen where a plane cuts.

/** Corners of the face opposite each corner of a tet, turning outward. */
const FACES = [1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1];

/** Node `k` of a face, given as 4 * tet + corner opposite. */
const nodeOf = (tets, face, k) => tets[(face & ~3) + FACES[3 * (face & 3) + k]];

const hash = (a, b, c) => Math.imul(a, 73856093) ^ Math.imul(b, 19349663) ^ Math.imul(c, 83492791);

/** Sorts the three nodes of a face into `out`. */
function sorted(tets, face, out) {
  const a = nodeOf(tets, face, 0),
    b = nodeOf(tets, face, 1),
    c = nodeOf(tets, face, 2);
  out[0] = Math.min(a, b, c);
  out[2] = Math.max(a, b, c);
  out[1] = a + b + c - out[0] - out[2];
}

/** For each face the same one of the other tet, -1 on the boundary. */
export function findNeighbours(tets) {
  const neighbours = new Int32Array(tets.length).fill(-1);
  let size = 1024;
  while (size < 2 * tets.length) size *= 2;
  const slots = new Int32Array(size).fill(-1);
  const key = [0, 0, 0],
    other = [0, 0, 0];
  for (let face = 0; face < tets.length; ++face) {
    sorted(tets, face, key);
    let slot = hash(...key) & (size - 1);
    for (; slots[slot] >= 0; slot = (slot + 1) & (size - 1)) {
      sorted(tets, slots[slot], other);
      if (key[0] === other[0] && key[1] === other[1] && key[2] === other[2]) break;
    }
    if (slots[slot] < 0) slots[slot] = face;
    else {
      neighbours[face] = slots[slot];
      neighbours[slots[slot]] = face;
    }
  }
  return neighbours;
}

/** For each face the boundary facet that it is, or -1. */
export function findFacets(tets, facets, facetTets) {
  const found = new Int32Array(tets.length).fill(-1);
  for (let facet = 0; facet < facetTets.length; ++facet) {
    const tet = facetTets[facet];
    for (let k = 0; k < 4; ++k) {
      const node = tets[4 * tet + k];
      const isCorner =
        node === facets[3 * facet] ||
        node === facets[3 * facet + 1] ||
        node === facets[3 * facet + 2];
      if (!isCorner) found[4 * tet + k] = facet;
    }
  }
  return found;
}

export function findCentroids(tets, nodes) {
  const centroids = new Float32Array((3 * tets.length) / 4);
  for (let tet = 0; 4 * tet < tets.length; ++tet)
    for (let axis = 0; axis < 3; ++axis) {
      let sum = 0;
      for (let k = 0; k < 4; ++k) sum += nodes[3 * tets[4 * tet + k] + axis];
      centroids[3 * tet + axis] = sum / 4;
    }
  return centroids;
}

/** Faces that are seen: `nodes` three a face; `facets` the boundary facet or -1; `tets` likewise. */
export class ShownFaces {
  constructor() {
    this.nodes = [];
    this.facets = [];
    this.tets = [];
  }

  add(a, b, c, facet, tet) {
    this.nodes.push(a, b, c);
    this.facets.push(facet);
    this.tets.push(tet);
  }

  get count() {
    return this.facets.length;
  }
}

export function wholeSurface({ facets, facet_tet: tets }) {
  const shown = new ShownFaces();
  for (let f = 0; 3 * f < facets.length; ++f)
    shown.add(facets[3 * f], facets[3 * f + 1], facets[3 * f + 2], f, tets ? tets[f] : -1);
  return shown;
}

/** Faces between tets whose centroid lies behind the plane and what is not shown. */
export function cutSurface(tets, topology, plane) {
  const { centroids, neighbours, facetOf } = topology;
  const behind = new Uint8Array(tets.length / 4);
  for (let tet = 0; tet < behind.length; ++tet)
    behind[tet] = plane.side * (centroids[3 * tet + plane.axis] - plane.position) <= 0 ? 1 : 0;
  const shown = new ShownFaces();
  for (let face = 0; face < tets.length; ++face) {
    if (!behind[face >> 2]) continue;
    const across = neighbours[face];
    if (across >= 0 && behind[across >> 2]) continue;
    shown.add(
      nodeOf(tets, face, 0),
      nodeOf(tets, face, 1),
      nodeOf(tets, face, 2),
      facetOf[face],
      face >> 2,
    );
  }
  return shown;
}
