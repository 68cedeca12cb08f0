/// How finely to draw. While the picture moves, a machine that cannot keep up gets fewer samples, then fewer pixels,
/// until it can. At rest every pixel is drawn, and smooth edges where the machine has shown that they are not waited for.

import type { Speed } from "./view";

export interface Quality {
  /// Of the canvas's pixels along each side.
  readonly scale: number;
  /// Of each pixel, for smooth edges.
  readonly samples: number;
}

const full: Quality = { scale: 1, samples: 4 };
const plain: Quality = { scale: 1, samples: 0 };
const moving: readonly Quality[] = [full, plain, { scale: 0.7, samples: 0 }, { scale: 0.5, samples: 0 }];

/// ms a frame above which moving is felt as slow, or as standing still, and below which a finer one is tried.
const slow = 34;
const verySlow = 140;
const swift = 9;
/// ms that a frame of finer meshes may take: while the picture moves, and at rest.
const fastFrame = 120;
const slowFrame = 1500;
/// ms that a picture at rest may take before it does without smooth edges, and may not take to get them again.
const longRest = 900;
const shortRest = 150;
/// To time a frame is to wait for it: the first ones of a movement, then few; at rest one in so many ms.
const firstFrames = 4;
const everyFrames = 16;
const restPause = 700;

/// ms without movement after which the picture rests: at least, and in relation to what a frame takes; a hand that drags
/// must not be held up by pictures at rest.
const restTime = 120;
const restFrames = 4;
const longestPause = 1000;
/// A picture of more triangles than this, and than twice as many as were drawn before, is one of which nothing is known.
const fewTriangles = 50_000;

export class Pace {
  private level = 0;
  private frames = 0;
  private timedAt = -Infinity;
  private fullCost = 0;
  private plainRest = true;
  /// ms that the last frame took that was waited for.
  private last = 0;
  /// ms a triangle, of the last frame with many; NaN: not known.
  private each = Number.NaN;
  /// Triangles of the largest picture so far; below 0: none was drawn, so that the shaders are still to be built.
  private known = -1;

  /// `triangles`: of the picture that is to be drawn.
  quality(inMotion: boolean, triangles: number): Quality {
    if (this.isNew(triangles)) return plain;
    if (inMotion) return moving[this.level] ?? full;
    return this.plainRest ? plain : full;
  }

  /// What such a picture costs is not known: it comes first, without what makes it finer.
  isNew(triangles: number): boolean {
    return this.known < 0 || triangles > 2 * this.known + fewTriangles;
  }

  /// ms without movement after which the picture rests.
  get rest(): number {
    return Math.min(longestPause, Math.max(restTime, restFrames * this.last));
  }

  /// ms that a full frame takes.
  get cost(): number {
    return this.fullCost;
  }

  /// How fast so many triangles are drawn, as far as is known.
  draws(triangles: number): Speed {
    const ms = this.each * triangles;
    return ms < fastFrame ? "fast" : ms < slowFrame ? "slowly" : "never";
  }

  wantsTime(now: number, inMotion: boolean, triangles: number): boolean {
    this.frames = inMotion ? this.frames + 1 : 0;
    // Not the one that builds the shaders: there is nothing to see in it yet.
    if (this.known < 0) return triangles > fewTriangles;
    if (!inMotion) return this.isNew(triangles) || now - this.timedAt > restPause;
    return this.frames <= firstFrames || this.frames % everyFrames === 0;
  }

  /// A frame was drawn; `ms`: what it took, null where nobody waited for it.
  drawn(now: number, ms: number | null, inMotion: boolean, triangles: number): void {
    const first = this.isNew(triangles);
    this.known = Math.max(this.known, triangles);
    if (ms === null) return;
    this.timedAt = now;
    this.last = ms;
    if (ms > longRest) this.plainRest = true;
    if (triangles > fewTriangles && (!first || ms < shortRest)) this.each = ms / triangles;
    // The first one also brings meshes and shaders to the card: that it took long says little.
    if (first && ms > shortRest) {
      this.level = Math.max(this.level, 1);
      return;
    }
    if (!inMotion) {
      // Single frames also draw shadows: those count little.
      const share = ms < this.fullCost || this.fullCost === 0 ? 1 : 0.3;
      this.fullCost += share * (ms - this.fullCost);
      if (this.fullCost > longRest) this.plainRest = true;
      else if (this.fullCost < shortRest) this.plainRest = false;
      if (ms < slow * 0.7) this.level = 0;
      else if (ms > slow && this.level === 0) this.level = 1;
      return;
    }
    if (ms > slow) this.level = Math.min(this.level + (ms > verySlow ? 2 : 1), moving.length - 1);
    else if (ms < swift && this.level > 1) this.level -= 1;
  }
}
