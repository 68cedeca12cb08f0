/// Set files, and what is taken in of files.

import { describe, expect, it } from "vitest";
import type { Parts, SetFile } from "../../src/api/types";
import { emptyDraft } from "../../src/app/state/draft";
import { decodeText, parseCsv, partsOfCsv } from "../../src/app/state/set_file";
import { leftOut, takeIn } from "../../src/app/state/take_in";
import { mesh } from "./mesh";

const none = new Set<string>();

describe("set files", () => {
  it("are read as RFC 4180 has them", () => {
    expect(parseCsv('\ufeffmesh,name\r\na.stl,"one, ""two"""\r\n\r\nb.stl,x')).toEqual([
      ["mesh", "name"],
      ["a.stl", 'one, "two"'],
      ["b.stl", "x"],
    ]);
  });

  it("may have semicolons and decimal commas", () => {
    const text = "file;quantity;scale;gap;due;orientations;unit\nparts/bracket.stl;12;1,5;;2026-12-01;upright;inch\n";
    expect(partsOfCsv(text, [mesh()], none)).toMatchObject([
      {
        file: "bracket.stl",
        count: 12,
        scale: 1.5,
        gap: null,
        due: "2026-12-01",
        stands: { kind: "upright" },
        unit: "inch",
      },
    ]);
  });

  it("names axes", () => {
    const parts = partsOfCsv("mesh,orientations\na.stl,+z -z\n", [], none);
    expect(parts?.[0]?.stands).toEqual({ kind: "axes", axes: ["+z", "-z"], yaw: null });
  });

  it("are none without a column of meshes", () => {
    expect(partsOfCsv("name,count\na,1\n", [], none)).toBeNull();
  });

  it("may be in the letters of a spreadsheet", () => {
    expect(decodeText(new Uint8Array([0x66, 0xfc, 0x72]).buffer)).toBe("für");
    expect(decodeText(new TextEncoder().encode("für").buffer as ArrayBuffer)).toBe("für");
  });
});

function parts(change: Partial<Parts>): Parts {
  return { reading: 0, meshes: [], bad: [], sets: [], ...change };
}

describe("files that were read", () => {
  const meshes = [mesh(), mesh({ id: 1, file: "knob.3mf", name: "knob", instances: 4 })];

  it("become parts, as often as their files hold them", () => {
    const draft = takeIn(emptyDraft, parts({ meshes }), new Set(["bracket.stl", "knob.3mf"]), new Map());
    expect(draft.parts.map((part) => [part.file, part.count])).toEqual([
      ["bracket.stl", 1],
      ["knob.3mf", 4],
    ]);
    // A file that is replaced is no second part.
    expect(takeIn(draft, parts({ meshes }), new Set(["bracket.stl"]), new Map())).toBe(draft);
  });

  it("take their counts from a set, and what it does not name is left out", () => {
    const set: SetFile = {
      file: "set.csv",
      kind: "set",
      rows: [{ mesh: "bracket.stl", name: "", count: 7, scale: 1, gap: null, priority: 0, due: null }],
      job: null,
      missing: [],
    };
    const all = parts({ meshes, sets: [set] });
    const fresh = new Set(["bracket.stl", "knob.3mf", "set.csv"]);
    const texts = new Map([["set.csv", "mesh,count,priority\nbracket.stl,7,1\n"]]);
    const draft = takeIn(emptyDraft, all, fresh, texts);
    expect(draft.parts).toMatchObject([{ file: "bracket.stl", count: 7, priority: 1 }]);
    expect(leftOut(draft, meshes).map((own) => own.file)).toEqual(["knob.3mf"]);
    // The server's rows do where the text could not be had.
    expect(takeIn(emptyDraft, all, fresh, new Map()).parts).toMatchObject([{ count: 7, priority: 0 }]);
  });

  it("are a whole draft where one is a job file", () => {
    const job: SetFile = {
      file: "job.json",
      kind: "job",
      rows: [],
      job: { parts: [{ mesh: "knob.3mf", count: 9 }], gap: 2 } as unknown as NonNullable<SetFile["job"]>,
      missing: [],
    };
    const draft = takeIn(emptyDraft, parts({ meshes, sets: [job] }), new Set(["job.json"]), new Map());
    expect(draft).toMatchObject({ gap: 2, parts: [{ file: "knob.3mf", count: 9 }] });
  });

  it("are not packed where they are filled", () => {
    const tray = { kind: "mesh", file: "bracket.stl", is: null, unit: null, transform: null } as const;
    const draft = takeIn({ ...emptyDraft, tray }, parts({ meshes }), new Set(["bracket.stl"]), new Map());
    expect(draft.parts).toEqual([]);
  });
});
