/// The timeline as shapes: a bar for each step, as high as it moves far; where there are more steps than room, the highest
/// of those that share a place.

import type { Plan } from "./apart_plan";

export interface Bar {
  /// 0 to 1 along the timeline.
  readonly from: number;
  readonly to: number;
  /// 0 to 1
  readonly height: number;
}

/// A step that moves nothing is still to be seen.
const least = 0.06;
/// The highest bar is drawn so that a few long ways do not flatten the rest: this share of the steps is not above it.
const mostShare = 0.98;

/// `most`: so many bars have room.
export function barsOf(plan: Plan, most: number): Bar[] {
  const count = plan.steps.length;
  const columns = Math.max(1, Math.min(count, Math.floor(most)));
  const heights = new Array<number>(columns).fill(0);
  for (const step of plan.steps) {
    const column = Math.min(columns - 1, Math.floor((step.index * columns) / count));
    heights[column] = Math.max(heights[column] ?? 0, step.length);
  }
  const sorted = [...heights].sort((a, b) => a - b);
  const top = sorted[Math.min(columns - 1, Math.floor(mostShare * columns))] || sorted[columns - 1] || 1;
  return heights.map((height, column) => ({
    from: column / columns,
    to: (column + 1) / columns,
    height: Math.max(least, Math.min(1, height / top)),
  }));
}

/// Numbers below the timeline: the first, the last, and round ones between, `apart` steps or more from each other.
export function ticksOf(count: number, apart: number): number[] {
  const round = [1, 2, 5].flatMap((one) => [1, 10, 100, 1000, 10_000].map((ten) => one * ten)).sort((a, b) => a - b);
  const by = round.find((step) => step >= apart) ?? count;
  const ticks = [1];
  for (let tick = by; tick < count; tick += by)
    if (tick - 1 >= apart * 0.6 && count - tick >= apart * 0.6) ticks.push(tick);
  if (count > 1) ticks.push(count);
  return ticks;
}
