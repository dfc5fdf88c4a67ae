// SPDX-License-Identifier: Apache-2.0
// What the page is built from, and on what terms.
import gui from "../../../LICENSES/lil-gui.txt";
import three from "../../../LICENSES/three.txt";
import bvh from "../../../LICENSES/three-mesh-bvh.txt";
import uplot from "../../../LICENSES/uplot.txt";

export const libraries = [
  { name: "three.js", use: "3-D", licence: three },
  { name: "three-mesh-bvh", use: "what lies under the pointer", licence: bvh },
  { name: "µPlot", use: "histograms", licence: uplot },
  { name: "lil-gui", use: "the panel", licence: gui },
];
