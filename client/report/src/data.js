// SPDX-License-Identifier: Apache-2.0
// Figures and arrays of the page, as the command wrote them.

/** Names of the values of `tet_state` and `facet_state`. */
export const STATES = ["new", "kept", "moved", "gone"];

const TYPES = { f32: Float32Array, i32: Int32Array, u8: Uint8Array };

function fromBase64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let k = 0; k < bytes.length; ++k) bytes[k] = characters.charCodeAt(k);
  return bytes;
}

async function unpack({ name, type, components, count, element }) {
  const packed = document.getElementById(element);
  const compressed = new Blob([fromBase64(packed.textContent)]).stream();
  packed.remove(); // the text would take memory for as long as the page is open
  const plain = compressed.pipeThrough(new DecompressionStream("deflate"));
  const numbers = new TYPES[type](await new Response(plain).arrayBuffer());
  if (numbers.length !== components * count) throw new Error(`the array ${name} is damaged`);
  return [name, numbers];
}

async function unpackMesh(mesh) {
  return Object.fromEntries(await Promise.all(mesh.arrays.map(unpack)));
}

/** The figures, with the arrays of each mesh as `arrays` of its side. */
export async function readReport() {
  const report = JSON.parse(document.getElementById("figures").textContent);
  for (const side of sidesOf(report)) side.arrays = await unpackMesh(side.mesh);
  return report;
}

/** The base, where there is one, and the new revision. */
export function sidesOf(report) {
  return report.base ? [report.base, report.modified] : [report.modified];
}
