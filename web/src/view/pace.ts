/// How finely to draw. While the picture moves, a machine that cannot keep up gets fewer samples, then fewer pixels,
/// until it can. At rest every pixel is drawn, and smooth edges unless they would be waited for.

export interface Quality {
  /// Of the canvas's pixels along each side.
  readonly scale: number;
  /// Of each pixel, for smooth edges.
  readonly samples: number;
}

const full: Quality = { scale: 1, samples: 4 };
const plain: Quality = { scale: 1, samples: 0 };
const moving: readonly Quality[] = [full, plain, { scale: 0.7, samples: 0 }, { scale: 0.5, samples: 0 }];

/// ms a frame above which moving is felt as slow, and below which a finer one is tried.
const slow = 34;
const swift = 9;
/// ms that a picture at rest may take before it does without smooth edges, and may not take to get them again.
const longRest = 900;
const shortRest = 150;
/// To time a frame is to wait for it: the first ones of a movement, then few; at rest one in so many ms.
const firstFrames = 4;
const everyFrames = 16;
const restPause = 700;

export class Pace {
  private level = 0;
  private frames = 0;
  private timedAt = -Infinity;
  private fullCost = 0;
  private warm = false;
  private plainRest = false;

  quality(inMotion: boolean): Quality {
    if (inMotion) return moving[this.level] ?? full;
    return this.plainRest ? plain : full;
  }

  get isCoarse(): boolean {
    return this.level > 0;
  }

  /// ms that a full frame takes.
  get cost(): number {
    return this.fullCost;
  }

  wantsTime(now: number, inMotion: boolean): boolean {
    this.frames = inMotion ? this.frames + 1 : 0;
    if (!inMotion) return now - this.timedAt > restPause;
    return this.frames <= firstFrames || this.frames % everyFrames === 0;
  }

  timed(now: number, ms: number, inMotion: boolean): void {
    this.timedAt = now;
    // The first frame of all builds the shaders, which is not done again.
    if (!this.warm) {
      this.warm = true;
      return;
    }
    if (!inMotion) {
      // Single frames also draw shadows: those count little.
      this.fullCost += (ms < this.fullCost ? 1 : 0.3) * (ms - this.fullCost);
      if (this.fullCost > longRest) this.plainRest = true;
      else if (this.fullCost < shortRest) this.plainRest = false;
      if (ms < slow * 0.7) this.level = 0;
      else if (ms > slow && this.level === 0) this.level = 1;
      return;
    }
    if (ms > slow && this.level + 1 < moving.length) this.level += 1;
    else if (ms < swift && this.level > 1) this.level -= 1;
  }
}
