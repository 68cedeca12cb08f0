/// Sunlight and the light between the copies, kept up to what stands. Both follow changes with a pause: many changes a
/// second must not slow down the frames, and nobody minds a shadow that comes a quarter of a second late.

import type { WebGLRenderer } from "three";
import type { Box } from "./affine";
import { ambientGrid, computeAmbient } from "./ambient";
import type { Pieces } from "./pieces";
import { isKept, planeOf } from "./section";
import { Sun } from "./sun";
import { setAmbient } from "./uniforms";
import type { Section } from "./view";

/// ms between two drawings of all shadows, between two of those that came, and of the light between the copies.
const shadowPause = 250;
const addedPause = 60;
const ambientPause = 450;
/// On a slow machine pauses are longer, but shadows must not seem to be forgotten.
const longestPause = 1200;

export class Daylight {
  readonly sun: Sun;
  private shadowsAt = -Infinity;
  private ambientAt = -Infinity;
  private ambientCost = 0;
  private ambientDirty = true;

  constructor(private readonly pieces: Pieces) {
    this.sun = new Sun(pieces.shared);
  }

  /// `box`: all that stands; `cost`: ms that a frame takes. Says in how many ms it is to be asked again, null: not before
  /// something changes.
  update(
    renderer: WebGLRenderer,
    now: number,
    box: Readonly<Box>,
    section: Section | null,
    cost: number,
  ): number | null {
    this.pieces.rested(now);
    const shadows = this.updateShadows(renderer, now, box, cost);
    const ambient = this.updateAmbient(now, box, section);
    return shadows === null || ambient === null ? (shadows ?? ambient) : Math.min(shadows, ambient);
  }

  /// No shadows, until the next update.
  clear(renderer: WebGLRenderer, box: Readonly<Box>): void {
    this.sun.clear(renderer, box);
    this.pieces.shadowsDirty = true;
    this.shadowsAt = this.ambientAt = -Infinity;
  }

  /// The graphics card lost everything.
  forget(): void {
    this.sun.dispose();
    this.sun.forget();
    this.pieces.shadowsDirty = true;
  }

  dispose(): void {
    this.sun.dispose();
  }

  private updateShadows(renderer: WebGLRenderer, now: number, box: Readonly<Box>, cost: number): number | null {
    const { pieces } = this;
    if (!pieces.shadowsDirty && pieces.shadowsAdded.length === 0) return null;
    const add = !pieces.shadowsDirty && this.sun.holds(box);
    const pause = Math.max(add ? addedPause : shadowPause, (add ? 1 : 5) * cost);
    const wait = this.shadowsAt + Math.min(longestPause, pause) - now;
    if (wait > 0) return wait;
    this.shadowsAt = now;
    this.ambientDirty = true;
    pieces.prepareShadows(add);
    pieces.useShadowList(true);
    this.sun.render(renderer, pieces.passes.shadows, box, add);
    pieces.useShadowList(false);
    this.sun.renderGround(renderer);
    return null;
  }

  private updateAmbient(now: number, box: Readonly<Box>, section: Section | null): number | null {
    if (!this.ambientDirty) return null;
    const wait = this.ambientAt + Math.max(ambientPause, 8 * this.ambientCost) - now;
    if (wait > 0) return wait;
    this.ambientDirty = false;
    this.ambientAt = now;
    const before = performance.now();
    const plane = section ? planeOf(section) : null;
    const keeps = plane ? (x: number, y: number, z: number) => isKept(plane, [x, y, z]) : null;
    setAmbient(this.pieces.shared, computeAmbient(box, this.pieces.surfaces(ambientGrid(box).cell), keeps));
    this.ambientCost = performance.now() - before;
    return null;
  }
}
