// SPDX-License-Identifier: Apache-2.0
// The one camera of all views: turning by mouse, touch and keys, and flights.
import { Box3, PerspectiveCamera, Sphere, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const FLIGHT = 600; // ms
const STEP = Math.PI / 24; // of a key

/** The box round the nodes of all meshes. */
export function boxRound(sides) {
  const box = new Box3();
  const point = new Vector3();
  for (const {
    arrays: { nodes },
  } of sides)
    for (let k = 0; k < nodes.length; k += 3) box.expandByPoint(point.fromArray(nodes, k));
  return box;
}

export class SharedCamera {
  constructor(canvas, box, onChange) {
    this.box = box;
    this.sphere = box.getBoundingSphere(new Sphere());
    this.onChange = onChange;
    this.camera = new PerspectiveCamera(28, 1, 1, 10);
    this.camera.up.set(0, 0, 1); // as parts are modelled
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.changed());
    this.controls.zoomToCursor = false;
    this.reset(false);
  }

  changed() {
    const { radius, center } = this.sphere;
    const far = this.camera.position.distanceTo(center) + 2 * radius;
    this.camera.far = far;
    this.camera.near = Math.max(far / 5000, Math.min(far - 4 * radius, this.distance() / 20));
    this.onChange();
  }

  distance() {
    return this.camera.position.distanceTo(this.controls.target);
  }

  /** The whole part, from a corner, as near as it fits. */
  reset(animated = true) {
    const direction = new Vector3(0.55, -0.75, 0.62).normalize();
    this.fly(this.sphere.center.clone(), direction.multiplyScalar(this.fit(direction)), animated);
  }

  /** Distance from which the whole box is seen, in this direction. */
  fit(direction) {
    const across = new Vector3().crossVectors(this.camera.up, direction).normalize();
    const above = new Vector3().crossVectors(direction, across);
    const high = Math.tan((this.camera.fov * Math.PI) / 360);
    const wide = high * (this.aspect ?? 1);
    let distance = 0;
    for (let k = 0; k < 8; ++k) {
      const { min, max } = this.box;
      const corner = new Vector3(
        k & 1 ? max.x : min.x,
        k & 2 ? max.y : min.y,
        k & 4 ? max.z : min.z,
      ).sub(this.sphere.center);
      const needed = Math.max(
        Math.abs(corner.dot(across)) / wide,
        Math.abs(corner.dot(above)) / high,
      );
      distance = Math.max(distance, needed + corner.dot(direction));
    }
    return 1.04 * distance || 1;
  }

  setAspect(aspect) {
    const before = this.aspect;
    this.aspect = aspect;
    if (before === undefined) this.reset(false);
    else if (before !== aspect) this.zoom(Math.min(1, before) / Math.min(1, aspect)); // as much as before
  }

  /** To look at a small thing from where the camera is. */
  lookAt(point, size) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    this.fly(point, offset.setLength(9 * size), true);
  }

  fly(target, offset, animated) {
    cancelAnimationFrame(this.flight);
    const still = !animated || matchMedia("(prefers-reduced-motion: reduce)").matches;
    const from = {
      target: this.controls.target.clone(),
      offset: this.camera.position.clone().sub(this.controls.target),
    };
    const begin = performance.now();
    const step = () => {
      const time = still ? 1 : Math.min(1, (performance.now() - begin) / FLIGHT);
      const share = time * time * (3 - 2 * time);
      this.controls.target.lerpVectors(from.target, target, share);
      this.camera.position.copy(from.offset).lerp(offset, share).add(this.controls.target);
      this.controls.update();
      this.changed();
      if (time < 1) this.flight = requestAnimationFrame(step);
    };
    step();
  }

  turn(right, up) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const around = new Spherical().setFromVector3(new Vector3(offset.x, offset.z, -offset.y));
    around.theta += right * STEP;
    around.phi = Math.min(Math.max(around.phi - up * STEP, 0.02), Math.PI - 0.02);
    const turned = new Vector3().setFromSpherical(around);
    this.fly(this.controls.target.clone(), new Vector3(turned.x, -turned.z, turned.y), false);
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    this.fly(this.controls.target.clone(), offset.multiplyScalar(factor), false);
  }

  /** Whether the key was one of the camera's. */
  key(name) {
    const keys = {
      ArrowLeft: () => this.turn(-1, 0),
      ArrowRight: () => this.turn(1, 0),
      ArrowUp: () => this.turn(0, 1),
      ArrowDown: () => this.turn(0, -1),
      "+": () => this.zoom(0.85),
      "=": () => this.zoom(0.85),
      "-": () => this.zoom(1 / 0.85),
      Home: () => this.reset(),
      0: () => this.reset(),
    };
    if (!keys[name]) return false;
    keys[name]();
    return true;
  }
}
