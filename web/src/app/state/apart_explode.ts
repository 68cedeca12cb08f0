/// All copies drawn apart: each away from the middle of the tray's floor, groups as one piece.

import type { Plan } from "./apart_plan";
import type { Sides } from "./draft";
import type { Extent } from "./turns";

/// Of a copy's distance to the middle of the floor.
const sideways = 0.55;
const upwards = 0.9;

/// By placement: mm from its place.
export function drawnApart(plan: Plan, extents: readonly (Extent | null)[], size: Sides): Sides[] {
  const offsets = extents.map((extent) => (extent ? away(extent, size) : ([0, 0, 0] as const)));
  // Copies that hold one another stay together; the outermost group comes first and has the last word.
  for (const own of [...plan.assemblies].reverse()) {
    if (own.madeBy < 0) continue;
    const box = union(own.members.flatMap((placement) => extents[placement] ?? []));
    if (!box) continue;
    for (const placement of own.members) offsets[placement] = away(box, size);
  }
  return offsets;
}

function away({ low, high }: Extent, size: Sides): Sides {
  const middle = [0, 1, 2].map((axis) => ((low[axis] ?? 0) + (high[axis] ?? 0)) / 2);
  return [
    sideways * ((middle[0] ?? 0) - size[0] / 2),
    sideways * ((middle[1] ?? 0) - size[1] / 2),
    // By its lower side, so that what lies on the floor stays there.
    upwards * low[2],
  ];
}

export function union(boxes: readonly Extent[]): Extent | null {
  const [first] = boxes;
  if (!first) return null;
  const low: [number, number, number] = [...first.low];
  const high: [number, number, number] = [...first.high];
  for (const box of boxes) {
    for (let axis = 0; axis < 3; axis += 1) {
      low[axis] = Math.min(low[axis] ?? 0, box.low[axis] ?? 0);
      high[axis] = Math.max(high[axis] ?? 0, box.high[axis] ?? 0);
    }
  }
  return { low, high };
}

export function moved({ low, high }: Extent, by: Sides): Extent {
  return {
    low: [low[0] + by[0], low[1] + by[1], low[2] + by[2]],
    high: [high[0] + by[0], high[1] + by[1], high[2] + by[2]],
  };
}
