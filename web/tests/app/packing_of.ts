/// A packing of one tray, or more, to change.

import { type Packing, readPacking } from "../../src/app/state/packing";

export const at = (x: number) => [
  [1, 0, 0, x],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

type Place = readonly [part: number, copy: number, x: number];

/// Bracket is twice as large as lid; every copy leaves at a step of its own, the last first.
export function packingOf(...trays: readonly (readonly Place[])[]): Packing {
  const places = trays.flat();
  const count = (own: number) => places.filter(([part]) => part === own).length;
  return readPacking({
    container: { size: [100, 100, 100] },
    parts: [
      { name: "bracket", mesh: "files/bracket.stl", count: count(0), volume: 1000 },
      { name: "lid", mesh: "files/lid.stl", count: count(1), volume: 500 },
    ],
    trays: trays.map((own) => ({
      placements: own.map(([part, copy, x]) => ({ part, copy, transform: at(x) })),
      density: 0.1,
      height: 50,
      disassembly: {
        complete: true,
        steps: own.map((_, i) => ({ placements: [own.length - 1 - i], path: [[0, 0, 100]] })),
      },
    })),
    metrics: { copies: places.length, placed: places.length, density: 0.1, min_gap: 2, improvement: null },
  });
}
