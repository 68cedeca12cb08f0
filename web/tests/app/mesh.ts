/// A mesh as the server tells of it, for tests.

import type { Mesh } from "../../src/api/types";

export function mesh(change: Partial<Mesh> = {}): Mesh {
  return {
    id: 0,
    file: "bracket.stl",
    object: null,
    name: "bracket",
    instances: 1,
    unit: 1,
    unit_known: false,
    unit_hint: null,
    size: [60, 40, 20],
    box: [
      [0, 0, 0],
      [60, 40, 20],
    ],
    volume: 12_000,
    triangles: 1200,
    watertight: true,
    shells: 1,
    repairs: [],
    warnings: [],
    ...change,
  };
}
