// SPDX-License-Identifier: Apache-2.0
// The meshes in 3-D, side by side or one alone, seen by one camera.
import { Raycaster, Vector2, Vector3, WebGLRenderer } from "three";
import { boxRound, SharedCamera } from "./camera.js";
import { faceName } from "./colours.js";
import { STATES } from "./data.js";
import { el, integer, short } from "./dom.js";
import { MeshView } from "./mesh_view.js";
import { theme } from "./theme.js";

const NARROW = 620; // pixels: views stand one above the other

export class Viewer {
  /** `modes` as of colourModes. Throws where the browser has no WebGL. */
  constructor(sides, modes) {
    this.sides = sides;
    this.modes = modes;
    this.settings = { mode: "state", layout: "both", edges: true, lit: null, plane: null };
    this.canvas = el("canvas", {
      tabindex: "0",
      role: "img",
      "aria-describedby": "viewer-keys",
      "aria-label": `The ${sides.length > 1 ? "meshes of BASE and NEW" : "mesh"} in 3-D`,
    });
    this.renderer = new WebGLRenderer({
      canvas: this.canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true,
    }); // kept for print
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.views = sides.map((side) => new MeshView(side));
    this.box = boxRound(sides);
    this.labels = sides.map((side) =>
      el(
        "div",
        { class: "view-label" },
        el("strong", {}, sides.length === 1 ? "Mesh" : side === sides[0] ? "BASE" : "NEW"),
        ` ${side.name}`,
        el("span", {}, `${integer(side.mesh.tets)} tets`),
      ),
    );
    this.tip = el("div", { class: "tip", role: "status" });
    this.tip.hidden = true;
    this.frame = el("div", { class: "views" }, this.canvas, this.labels, this.tip);
    this.shared = new SharedCamera(this.canvas, this.box, () => this.invalidate());
    this.lights = MeshView.lights();
    this.shared.camera.add(...this.lights);
    this.raycaster = new Raycaster();
    this.raycaster.firstHitOnly = true;
    this.listen();
    this.repaint();
  }

  listen() {
    new ResizeObserver(() => this.resize()).observe(this.frame);
    this.canvas.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.setFocus(null);
      else if (!this.shared.key(event.key)) return;
      event.preventDefault();
    });
    this.canvas.addEventListener(
      "pointermove",
      (event) => event.buttons === 0 && this.hover(event),
    );
    this.canvas.addEventListener("pointerdown", () => (this.tip.hidden = true));
    this.canvas.addEventListener("click", (event) => this.hover(event)); // a touch does not hover
    this.canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
  }

  /** Takes settings, and does again what depends on them. */
  set(changes) {
    Object.assign(this.settings, changes);
    if ("mode" in changes) this.settings.lit = null;
    if ("plane" in changes) this.views.forEach((view) => view.cut(this.settings.plane));
    if ("layout" in changes) this.resize();
    this.repaint();
  }

  repaint() {
    const colours = theme();
    for (const view of this.views) {
      view.paint(this.modes[this.settings.mode], this.settings.lit, colours);
      view.setEdges(this.settings.edges);
    }
    this.invalidate();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.frame;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    const { layout } = this.settings;
    const chosen = this.views.filter(
      (_, k) =>
        layout === "both" || layout === (k === 0 ? "base" : "modified") || this.views.length === 1,
    );
    const stacked = width < NARROW;
    this.parts = chosen.map((view, k) => {
      const n = chosen.length;
      const w = stacked ? width : width / n,
        h = stacked ? height / n : height;
      return { view, x: stacked ? 0 : k * w, y: stacked ? k * h : 0, w, h };
    });
    this.labels.forEach((label, k) => {
      const part = this.parts.find(({ view }) => view === this.views[k]);
      label.hidden = !part;
      if (part)
        Object.assign(label.style, {
          left: `${(100 * part.x) / width}%`,
          top: `${(100 * part.y) / height}%`,
        });
    });
    this.frame.classList.toggle("stacked", stacked && chosen.length > 1);
    this.frame.classList.toggle("paired", !stacked && chosen.length > 1);
    this.shared.setAspect(this.parts[0].w / this.parts[0].h);
    this.invalidate();
  }

  invalidate() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.render();
    });
  }

  render() {
    if (!this.parts) return;
    const { camera } = this.shared;
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    for (const { view, x, y, w, h } of this.parts) {
      const bottom = this.frame.clientHeight - y - h;
      this.renderer.setViewport(x, bottom, w, h);
      this.renderer.setScissor(x, bottom, w, h);
      camera.aspect = w / h;
      camera.updateProjectionMatrix();
      view.scene.add(camera); // lights hang on the camera
      this.renderer.render(view.scene, camera);
    }
    this.frame.dataset.faces = this.views.map((view) => view.shown.count).join(" ");
  }

  hover(event) {
    const { left, top } = this.canvas.getBoundingClientRect();
    const at = { x: event.clientX - left, y: event.clientY - top };
    const part = this.parts.find(
      ({ x, y, w, h }) => at.x >= x && at.x < x + w && at.y >= y && at.y < y + h,
    );
    if (!part) return;
    const { camera } = this.shared;
    camera.aspect = part.w / part.h;
    camera.updateProjectionMatrix();
    const place = new Vector2(
      (2 * (at.x - part.x)) / part.w - 1,
      1 - (2 * (at.y - part.y)) / part.h,
    );
    this.raycaster.setFromCamera(place, camera);
    const face = part.view.pick(this.raycaster);
    this.tip.hidden = face < 0;
    if (face < 0) return;
    this.tip.replaceChildren(...this.describe(part.view, face));
    const beside = at.x > this.frame.clientWidth / 2 ? at.x - this.tip.offsetWidth - 14 : at.x + 14;
    Object.assign(this.tip.style, { left: `${beside}px`, top: `${at.y + 14}px` });
  }

  /** What is told of a face under the pointer. */
  describe({ side, shown }, face) {
    const { arrays, mesh } = side;
    const facet = shown.facets[face],
      tet = shown.tets[face];
    const of = (name) => (facet >= 0 ? arrays[`facet_${name}`][facet] : arrays[`tet_${name}`][tet]);
    const rows = [
      ["Tet", tet >= 0 ? `${integer(tet)}, ${STATES[of("state")]}` : STATES[of("state")]],
      ["Volume-length", (of("quality") / 255).toFixed(2)],
      ["Feature", mesh.cell_owners[of("cell")]?.join(", ") ?? "–"],
      ["Face", facet >= 0 ? faceName(side, arrays.facet_group[facet]) : "inside"],
    ];
    if (arrays.sizes) {
      const sizes = [0, 1, 2].map((k) => arrays.sizes[shown.nodes[3 * face + k]]);
      rows.push(["Size asked for", short(sizes.reduce((a, b) => a + b) / 3, 3)]);
    }
    return rows.map(([name, value]) => el("div", {}, el("span", {}, name), value));
  }

  /** Flies to a tet of the report's list and shows it through the others; null: shows all again. */
  setFocus(worst, sideNumber, centre) {
    const corners =
      worst?.corners.map((corner) => corner.map((value, k) => value - centre[k])) ?? null;
    this.views.forEach((view, k) => view.setFocus(k === sideNumber ? corners : null));
    this.onFocus?.(corners !== null);
    if (corners) {
      const { layout } = this.settings;
      const name = sideNumber === 0 && this.views.length > 1 ? "base" : "modified";
      if (layout !== "both" && layout !== name) this.set({ layout: name });
      const points = corners.map((corner) => new Vector3(...corner));
      const middle = points.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(4);
      this.shared.lookAt(middle, Math.max(...points.map((p) => p.distanceTo(middle))));
    }
    this.invalidate();
  }
}
