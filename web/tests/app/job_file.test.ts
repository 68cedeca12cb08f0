/// Drafts as job files, and back.

import { describe, expect, it } from "vitest";
import type { JsonObject } from "../../src/api/types";
import { type Draft, emptyDraft, newPart } from "../../src/app/state/draft";
import { addKeepOut, getOption, setOption, setTray } from "../../src/app/state/draft_edit";
import { fromJobFile } from "../../src/app/state/job_file_read";
import { toJobFile } from "../../src/app/state/job_file_write";
import { mesh } from "./mesh";

const meshes = [
  mesh(),
  mesh({ id: 1, file: "set.3mf", object: "2", name: "lid" }),
  mesh({ id: 2, file: "set.3mf", object: "4", name: "cup" }),
];

const full: Draft = {
  ...emptyDraft,
  parts: [
    {
      ...newPart("bracket.stl", null, "bracket.stl"),
      name: "Bracket",
      count: 12,
      scale: 1.02,
      unit: "inch",
      stands: { kind: "axes", axes: ["+z", "-z"], yaw: 45 },
      gap: 2,
      priority: 1,
      due: "2026-12-01",
      order: "A-2291",
      value: 4.5,
    },
    { ...newPart("set.3mf", "2", "set.3mf#2"), stands: { kind: "upright" } },
    { ...newPart("set.3mf", "4", "set.3mf#4"), stands: { kind: "fixed" }, priority: -1 },
  ],
  tray: { kind: "printer", name: "hp-mjf-5200" },
  trays: "all",
  keepOut: [
    {
      box: [
        [0, 0, 0],
        [10, 20, 380],
      ],
    },
  ],
  gap: 3,
  wallGap: 5,
  goal: "lowest",
  timeLimit: 300,
  material: "PA 12",
  options: { voxel: 1, rotations: "45", improve: "rest" },
};

const roundTrip = (draft: Draft) => fromJobFile(JSON.parse(JSON.stringify(toJobFile(draft))) as JsonObject, meshes);

describe("a draft as a job file", () => {
  it("comes back as it was", () => {
    expect(roundTrip(full)).toEqual(full);
  });

  it("says only what differs from the defaults", () => {
    const draft: Draft = { ...emptyDraft, parts: [newPart("bracket.stl", null, "bracket.stl")], goal: "fill" };
    expect(toJobFile(draft)).toEqual({
      format: "spectralpack/job",
      version: 1,
      unit: "mm",
      container: { size: [480, 245, 200] },
      parts: [{ mesh: "bracket.stl", count: 1 }],
    });
  });

  it("says the goal in the program's options", () => {
    const options = (draft: Draft) => toJobFile(draft).options;
    expect(options({ ...emptyDraft, goal: "lowest" })).toEqual({ "height-at": "top" });
    expect(options({ ...emptyDraft, goal: "box" })).toEqual({ minimise: "box" });
    expect(options({ ...emptyDraft, goal: "fill" })).toBeUndefined();
    for (const goal of ["lowest", "fill", "box"] as const) expect(roundTrip({ ...emptyDraft, goal }).goal).toBe(goal);
  });

  it("keeps a height that counts at the bottom, which is no goal of the page", () => {
    const draft: Draft = { ...emptyDraft, goal: "fill", options: { "height-at": "bottom" } };
    expect(roundTrip(draft)).toEqual(draft);
  });

  it("asks for one tray where one holds all", () => {
    expect(toJobFile({ ...emptyDraft, goal: "box", trays: 3 }).trays).toBeUndefined();
    expect(toJobFile({ ...emptyDraft, openHeight: true, trays: "all" })).toMatchObject({ open_height: true });
    expect(toJobFile({ ...emptyDraft, openHeight: true, trays: "all" }).trays).toBeUndefined();
  });

  it("does not improve until a limit that is not there", () => {
    expect(toJobFile({ ...full, timeLimit: null }).options).not.toHaveProperty("improve");
  });

  it("fills a mesh", () => {
    const draft: Draft = {
      ...emptyDraft,
      tray: { kind: "mesh", file: "cup.stl", is: "vessel", unit: "inch", transform: null },
      physical: true,
      goal: "fill",
    };
    expect(toJobFile(draft).container).toEqual({ mesh: "cup.stl", unit: "inch", is: "vessel", physical: true });
    expect(roundTrip(draft)).toEqual(draft);
  });
});

describe("job files of others", () => {
  it("takes keys that may stand in two places", () => {
    const draft = fromJobFile(
      { parts: [], options: { tray: [300, 200], "open-height": true, gap: 1, "wall-gap": 2, trays: 2, unit: "inch" } },
      [],
    );
    expect(draft).toMatchObject({
      tray: { kind: "box", size: [300, 200, 0] },
      openHeight: true,
      gap: 1,
      wallGap: 2,
      trays: 2,
      unit: "inch",
      options: {},
    });
    expect(toJobFile(draft).container).toEqual({ size: [300, 200] });
  });

  it("finds meshes by their names, and takes all objects of a file", () => {
    const draft = fromJobFile({ parts: [{ mesh: "parts/set.3mf", count: 3 }, { mesh: "gone.stl" }] }, meshes);
    expect(draft.parts.map((part) => [part.file, part.object, part.count])).toEqual([
      ["set.3mf", "2", 3],
      ["set.3mf", "4", 3],
      ["gone.stl", null, 1],
    ]);
  });

  it("tells the same mesh at two scales apart", () => {
    const { parts } = fromJobFile({ parts: [{ mesh: "bracket.stl" }, { mesh: "bracket.stl", scale: 2 }] }, meshes);
    expect(new Set(parts.map((part) => part.key)).size).toBe(2);
  });

  it("keeps turns and fixed copies that the page cannot edit", () => {
    const file = {
      parts: [{ mesh: "bracket.stl", orientations: { matrices: [[[1, 0, 0]]] } }],
      fixed: [{ mesh: "bar.stl" }],
    };
    const draft = fromJobFile(file, meshes);
    expect(draft.parts[0]?.stands.kind).toBe("matrices");
    expect(toJobFile(draft)).toMatchObject(file);
  });
});

describe("changes", () => {
  it("takes no least box with a mesh to fill or with keep-outs", () => {
    const box: Draft = { ...emptyDraft, goal: "box" };
    const mesh = { kind: "mesh", file: "cup.stl", is: null, unit: null, transform: null } as const;
    expect(setTray(box, mesh).goal).toBe("fill");
    expect(addKeepOut({ ...box, openHeight: true }, { mesh: "pin.stl", transform: null, unit: null })).toMatchObject({
      goal: "fill",
      openHeight: false,
    });
  });

  it("knows that the goal is an option, too", () => {
    expect(getOption(emptyDraft, "height-at")).toBe("top");
    const bottom = setOption(emptyDraft, "height-at", "bottom");
    expect(bottom).toMatchObject({ goal: "fill", options: { "height-at": "bottom" } });
    expect(setOption(bottom, "height-at", "top")).toMatchObject({ goal: "lowest", options: {} });
    expect(setOption({ ...emptyDraft, options: { voxel: 1 } }, "voxel", undefined).options).toEqual({});
  });
});
