/// What the page writes is what the program's schema of job files allows.

import { readFileSync } from "node:fs";
import Ajv2020 from "ajv/dist/2020";
import addFormats from "ajv-formats";
import { describe, expect, it } from "vitest";
import { type Draft, emptyDraft, newPart } from "../../src/app/state/draft";
import { toJobFile } from "../../src/app/state/job_file_write";

const ajv = new Ajv2020({ strict: false });
addFormats(ajv);
const valid = ajv.compile(JSON.parse(readFileSync("../docs/job.schema.json", "utf8")));

const drafts: Readonly<Record<string, Draft>> = {
  empty: emptyDraft,
  "a printer": { ...emptyDraft, tray: { kind: "printer", name: "hp-mjf-5200" }, gap: 3, wallGap: 5, trays: "all" },
  "no ceiling": { ...emptyDraft, openHeight: true, tray: { kind: "box", size: [300, 200, 0] } },
  "the least box": { ...emptyDraft, goal: "box", trays: 3 },
  "a mesh to fill": {
    ...emptyDraft,
    tray: { kind: "mesh", file: "cup.stl", is: "vessel", unit: "inch", transform: null },
    physical: true,
  },
  zones: {
    ...emptyDraft,
    keepOut: [
      {
        box: [
          [0, 0, 0],
          [10, 20, 30],
        ],
      },
      { mesh: "pin.stl", transform: null, unit: "mm" },
    ],
  },
  "parts of all kinds": {
    ...emptyDraft,
    parts: [
      { ...newPart("a.stl", null, "a"), name: "A", count: 12, scale: 1.02, unit: "inch", gap: 2, priority: -1 },
      { ...newPart("b.stl", null, "b"), stands: { kind: "upright" }, due: "2026-12-01", order: "A-1", value: 4.5 },
      { ...newPart("c.stl", null, "c"), stands: { kind: "axes", axes: ["+z", "-x"], yaw: 90 } },
    ],
  },
  options: {
    ...emptyDraft,
    timeLimit: 300,
    material: "PA 12",
    options: { voxel: 1, rotations: "45", improve: "rest", refine: false, "height-penalty": "auto", unpack: "any" },
  },
};

describe("job files of the page", () => {
  for (const [name, draft] of Object.entries(drafts)) {
    it(`are valid: ${name}`, () => {
      const file = JSON.parse(JSON.stringify(toJobFile(draft)));
      expect(valid(file), JSON.stringify(valid.errors)).toBe(true);
    });
  }
});
