/// A free place near a copy that was turned, or that had none before: farther and farther along the axes.

import type { Transform } from "../../view/view";
import type { Sides } from "../state/draft";
import { shifted } from "./placing";

export interface Ground {
  touchesNothing(transform: Transform): boolean;
  mayStand(transform: Transform): Promise<boolean>;
}

const directions: readonly Sides[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];
/// mm: the first step, how much longer each is, and how far at most.
const firstStep = 0.5;
const growth = 1.12;
const farthest = 400;
const mostAsked = 24;

/// Null where none was found.
export async function outward(from: Transform, ground: Ground): Promise<Transform | null> {
  let asked = 0;
  for (let far = firstStep; far < farthest; far *= growth) {
    for (const [x, y, z] of directions) {
      const at = shifted(from, [x * far, y * far, z * far]);
      if (!ground.touchesNothing(at)) continue;
      asked += 1;
      if (await ground.mayStand(at)) return at;
      if (asked >= mostAsked) return null;
    }
  }
  return null;
}
