/// Where the viewer is: an eye on a sphere round a target, z up. Maths only, so that picking, labels and tests share it.

import type { Box } from "./affine";
import type { Size } from "./view";

export interface Orbit {
  readonly target: Size;
  readonly distance: number;
  /// Radians; 0 looks from +x, a quarter turn from +y.
  readonly azimuth: number;
  /// Radians; 0 is level, a quarter turn looks straight down.
  readonly elevation: number;
}

export interface Lens {
  /// Vertical field of view, radians.
  readonly view: number;
  /// Width by height.
  readonly aspect: number;
}

export interface Basis {
  readonly right: Size;
  readonly up: Size;
  /// From the target towards the eye.
  readonly back: Size;
  readonly eye: Size;
}

export interface Ray {
  readonly origin: Size;
  /// Of length 1.
  readonly direction: Size;
}

/// As the design shows trays: the x axis runs down to the right, y up to the right.
export const homeAzimuth = (-62 * Math.PI) / 180;
export const homeElevation = (27 * Math.PI) / 180;
export const lensView = (30 * Math.PI) / 180;

const steepest = Math.PI / 2;

export function dot(a: Size, b: Size): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function along(p: Size, d: Size, length: number): [number, number, number] {
  return [p[0] + d[0] * length, p[1] + d[1] * length, p[2] + d[2] * length];
}

export function basisOf({ target, distance, azimuth, elevation }: Orbit): Basis {
  const ca = Math.cos(azimuth);
  const sa = Math.sin(azimuth);
  const ce = Math.cos(elevation);
  const se = Math.sin(elevation);
  const back: Size = [ce * ca, ce * sa, se];
  return { right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], back, eye: along(target, back, distance) };
}

export function turned(orbit: Orbit, azimuth: number, elevation: number): Orbit {
  return {
    ...orbit,
    azimuth: orbit.azimuth + azimuth,
    elevation: Math.min(steepest, Math.max(-steepest, orbit.elevation + elevation)),
  };
}

/// Moves what is at the target's depth by so many pixels, as if it were held.
export function panned(orbit: Orbit, dx: number, dy: number, height: number, lens: Lens): Orbit {
  const { right, up } = basisOf(orbit);
  const mm = mmAPixel(orbit, height, lens);
  return { ...orbit, target: along(along(orbit.target, right, -dx * mm), up, dy * mm) };
}

/// At the target's depth.
export function mmAPixel(orbit: Orbit, height: number, lens: Lens): number {
  return (2 * orbit.distance * Math.tan(lens.view / 2)) / Math.max(1, height);
}

/// Comes nearer (factor below 1) or goes away, and leaves `pivot` where it is on screen.
export function zoomed(orbit: Orbit, factor: number, pivot: Size, nearest: number, farthest: number): Orbit {
  const distance = Math.min(farthest, Math.max(nearest, orbit.distance * factor));
  const f = distance / orbit.distance;
  const [px, py, pz] = pivot;
  const [tx, ty, tz] = orbit.target;
  return { ...orbit, distance, target: [px + (tx - px) * f, py + (ty - py) * f, pz + (tz - pz) * f] };
}

/// `x` and `y` from -1 to 1, y up.
export function rayAt(orbit: Orbit, lens: Lens, x: number, y: number): Ray {
  const { right, up, back, eye } = basisOf(orbit);
  const h = Math.tan(lens.view / 2);
  const d = along(along([-back[0], -back[1], -back[2]], right, x * h * lens.aspect), up, y * h);
  const length = Math.hypot(...d);
  return { origin: eye, direction: [d[0] / length, d[1] / length, d[2] / length] };
}

/// Where the ray meets the plane through the target that faces the viewer.
export function onTargetPlane(orbit: Orbit, ray: Ray): Size {
  const { back } = basisOf(orbit);
  const slope = -dot(ray.direction, back);
  return along(ray.origin, ray.direction, orbit.distance / Math.max(1e-6, slope));
}

/// `x` and `y` from -1 to 1 where it is on screen; `depth` mm before the eye, not above 0 behind it.
export function project(orbit: Orbit, lens: Lens, p: Size): { x: number; y: number; depth: number } {
  const { right, up, back, eye } = basisOf(orbit);
  const v: Size = [p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]];
  const depth = -dot(v, back);
  const h = Math.tan(lens.view / 2) * Math.max(1e-9, depth);
  return { x: dot(v, right) / (h * lens.aspect), y: dot(v, up) / h, depth };
}

/// The orbit, seen from the same side, in which a box fills `share` of the screen's width or height.
export function framed(orbit: Orbit, lens: Lens, box: Readonly<Box>, share: number): Orbit {
  const centre: Size = [(box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2];
  const { right, up, back } = basisOf({ ...orbit, target: centre });
  const tanY = Math.tan(lens.view / 2) * share;
  const tanX = tanY * lens.aspect;
  let target = centre;
  let distance = 0;
  // Perspective draws what is near larger, so the middle of a box is not the middle of its picture: two rounds of
  // moving the target there are enough.
  for (let round = 0; round < 3; ++round) {
    distance = 0;
    for (const c of corners(box)) {
      const v: Size = [c[0] - target[0], c[1] - target[1], c[2] - target[2]];
      const towards = dot(v, back);
      distance = Math.max(distance, towards + Math.abs(dot(v, right)) / tanX, towards + Math.abs(dot(v, up)) / tanY);
    }
    const spread = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
    for (const c of corners(box)) {
      const p = project({ ...orbit, target, distance }, lens, c);
      spread.left = Math.min(spread.left, p.x);
      spread.right = Math.max(spread.right, p.x);
      spread.low = Math.min(spread.low, p.y);
      spread.high = Math.max(spread.high, p.y);
    }
    const h = Math.tan(lens.view / 2) * distance;
    target = along(target, right, ((spread.left + spread.right) / 2) * h * lens.aspect);
    target = along(target, up, ((spread.low + spread.high) / 2) * h);
  }
  return { ...orbit, target, distance: Math.max(distance, 1e-3) };
}

export function corners(box: Readonly<Box>): Size[] {
  const [x0, y0, z0, x1, y1, z1] = box;
  return [
    [x0, y0, z0],
    [x1, y0, z0],
    [x1, y1, z0],
    [x0, y1, z0],
    [x0, y0, z1],
    [x1, y0, z1],
    [x1, y1, z1],
    [x0, y1, z1],
  ];
}

/// Nearest and farthest depth of a box, for the depth buffer; at least a little before the eye.
export function depthRange(orbit: Orbit, box: Readonly<Box>): { near: number; far: number } {
  const { back, eye } = basisOf(orbit);
  let near = Infinity;
  let far = -Infinity;
  for (const c of corners(box)) {
    const depth = -dot([c[0] - eye[0], c[1] - eye[1], c[2] - eye[2]], back);
    near = Math.min(near, depth);
    far = Math.max(far, depth);
  }
  const spare = 0.02 * Math.max(1e-3, far - near);
  far = Math.max(far + spare, 1e-2);
  return { near: Math.max(near - spare, far / 5000), far };
}

/// Between two orbits on the shortest way round; distances in proportion, so that zooming feels even.
export function between(a: Orbit, b: Orbit, share: number): Orbit {
  const full = 2 * Math.PI;
  const way = ((((b.azimuth - a.azimuth + Math.PI) % full) + full) % full) - Math.PI;
  const at = (p: number, q: number) => p + (q - p) * share;
  return {
    target: [at(a.target[0], b.target[0]), at(a.target[1], b.target[1]), at(a.target[2], b.target[2])],
    distance: a.distance * (b.distance / a.distance) ** share,
    azimuth: a.azimuth + way * share,
    elevation: at(a.elevation, b.elevation),
  };
}
