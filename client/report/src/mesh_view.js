// SPDX-License-Identifier: Apache-2.0
// One mesh as a scene: its surface, or what a plane leaves of it, in the colours of a mode.
import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Scene,
} from "three";
import { acceleratedRaycast, MeshBVH } from "three-mesh-bvh";
import { mix, paintFace, parse } from "./colours.js";
import { cutSurface, findCentroids, findFacets, findNeighbours, wholeSurface } from "./topology.js";

/** Draws the edges of faces, whose corners come three by three, in the fragments beside them. */
function addEdges(material) {
  material.userData.edges = { value: 1 };
  material.userData.edgeColour = { value: new Color() };
  material.onBeforeCompile = (shader) => {
    shader.uniforms.edges = material.userData.edges;
    shader.uniforms.edgeColour = material.userData.edgeColour;
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vCorner;")
      .replace(
        "#include <begin_vertex>",
        `#include <begin_vertex>
        int corner = gl_VertexID % 3;
        vCorner = vec3(corner == 0, corner == 1, corner == 2);`,
      );
    shader.fragmentShader = shader.fragmentShader
      .replace(
        "#include <common>",
        `#include <common>
        varying vec3 vCorner;
        uniform float edges;
        uniform vec3 edgeColour;`,
      )
      .replace(
        "#include <color_fragment>",
        `#include <color_fragment>
        vec3 step3 = fwidth(vCorner);
        vec3 inside = smoothstep(vec3(0.0), 1.2 * step3, vCorner);
        float edge = 1.0 - min(min(inside.x, inside.y), inside.z);
        // Where triangles are a few pixels wide, edges would be all that is seen.
        edge *= 1.0 - smoothstep(0.12, 0.45, max(step3.x, max(step3.y, step3.z)));
        diffuseColor.rgb = mix(diffuseColor.rgb, edgeColour, edges * edge);`,
      );
  };
}

export class MeshView {
  constructor(side) {
    this.side = side;
    this.scene = new Scene();
    this.material = new MeshLambertMaterial({
      vertexColors: true,
      flatShading: true,
      side: DoubleSide,
    });
    addEdges(this.material);
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.raycast = acceleratedRaycast;
    this.scene.add(this.mesh);
    this.focus = this.makeFocus();
    this.shown = wholeSurface(side.arrays);
    this.fillPositions();
  }

  /** Light from the camera, which both scenes share: see Viewer. */
  static lights() {
    const ambient = new AmbientLight(0xffffff, 1.25);
    const head = new DirectionalLight(0xffffff, 2.35);
    head.position.set(0.35, 0.5, 1);
    return [ambient, head];
  }

  makeFocus() {
    const faces = new Mesh(
      new BufferGeometry(),
      new MeshBasicMaterial({
        side: DoubleSide,
        depthTest: false,
        transparent: true,
        opacity: 0.55,
      }),
    );
    const edges = new LineSegments(
      new BufferGeometry(),
      new LineBasicMaterial({ depthTest: false, transparent: true }),
    );
    faces.renderOrder = 1;
    edges.renderOrder = 2;
    faces.visible = edges.visible = false;
    this.scene.add(faces, edges);
    return { faces, edges };
  }

  /** Only made when a plane first cuts: it takes half a second for 300,000 tets. */
  get topology() {
    const { tets, nodes, facets, facet_tet: facetTets } = this.side.arrays;
    this.knownTopology ??= {
      neighbours: findNeighbours(tets),
      facetOf: findFacets(tets, facets, facetTets),
      centroids: findCentroids(tets, nodes),
    };
    return this.knownTopology;
  }

  /** `plane`: null, or axis (0 to 2), position and side (1 or -1: which half stays). */
  cut(plane) {
    const { tets } = this.side.arrays;
    this.shown =
      plane && tets ? cutSurface(tets, this.topology, plane) : wholeSurface(this.side.arrays);
    this.fillPositions();
  }

  fillPositions() {
    const { nodes } = this.side.arrays;
    const positions = new Float32Array(3 * this.shown.nodes.length);
    this.shown.nodes.forEach((node, k) => {
      positions[3 * k] = nodes[3 * node];
      positions[3 * k + 1] = nodes[3 * node + 1];
      positions[3 * k + 2] = nodes[3 * node + 2];
    });
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setAttribute("position", new BufferAttribute(positions, 3));
    this.mesh.visible = positions.length > 0;
  }

  /** Colours what is shown; `lit`: the key of a category that alone keeps its colour, or null. */
  paint(mode, lit, theme) {
    const colours = new Map();
    const palette = {
      dimmed: mix(parse(theme.neutral), parse(theme.card), 0.55),
      of: (key) => {
        if (!colours.has(key)) colours.set(key, mode.colour(key, theme));
        return colours.get(key);
      },
    };
    const { shown } = this;
    const colour = new Float32Array(3 * shown.nodes.length);
    const corners = [0, 0, 0];
    for (let face = 0; face < shown.count; ++face) {
      for (let k = 0; k < 3; ++k) corners[k] = shown.nodes[3 * face + k];
      paintFace(
        mode,
        this.side,
        shown.facets[face],
        shown.tets[face],
        corners,
        palette,
        lit,
        colour,
        9 * face,
      );
    }
    this.mesh.geometry.setAttribute("color", new BufferAttribute(colour, 3));
    this.material.userData.edgeColour.value.set(theme.edge);
    this.focus.faces.material.color.set(theme.alarm);
    this.focus.edges.material.color.set(theme.ink);
  }

  setEdges(isOn) {
    this.material.userData.edges.value = isOn ? 0.55 : 0;
  }

  /** Shows one tet through all others, which become faint; null: none. */
  setFocus(corners) {
    this.material.transparent = corners !== null;
    this.material.opacity = corners === null ? 1 : 0.28;
    this.material.depthWrite = corners === null;
    this.material.needsUpdate = true;
    this.focus.faces.visible = this.focus.edges.visible = corners !== null;
    if (corners === null) return;
    const pick = (order) =>
      new BufferAttribute(new Float32Array(order.flatMap((k) => corners[k])), 3);
    this.focus.faces.geometry.setAttribute("position", pick([1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1]));
    this.focus.edges.geometry.setAttribute("position", pick([0, 1, 1, 2, 2, 0, 0, 3, 1, 3, 2, 3]));
    for (const shape of [this.focus.faces, this.focus.edges]) {
      shape.geometry.attributes.position.needsUpdate = true;
      shape.geometry.computeBoundingSphere();
    }
  }

  /** Number of the face that a ray meets first, or -1. */
  pick(raycaster) {
    if (!this.mesh.visible) return -1;
    this.mesh.geometry.boundsTree ??= new MeshBVH(this.mesh.geometry, { indirect: true });
    const [hit] = raycaster.intersectObject(this.mesh, false);
    return hit ? hit.faceIndex : -1;
  }
}
