/// Keys, addresses, file names, and which rows are in sight.

import { describe, expect, it } from "vitest";
import { sightOf } from "../../src/app/parts/sight";
import { matches, nameOf } from "../../src/app/shell/key_names";
import { jobName, nameFiles, type PickedFile } from "../../src/app/state/file_names";
import { hashOf, parseRoute } from "../../src/app/state/route";

const press = (key: string, change: Partial<Parameters<typeof nameOf>[0]> = {}) =>
  nameOf({ key, code: "", ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...change });

describe("keys", () => {
  it("are named as they are written", () => {
    expect(press("z", { ctrlKey: true })).toBe("Ctrl+Z");
    expect(press("Z", { metaKey: true, shiftKey: true })).toBe("Ctrl+Shift+Z");
    expect(press("f")).toBe("F");
    expect(press("F", { shiftKey: true })).toBe("Shift+F");
    expect(press("{", { code: "BracketLeft", shiftKey: true })).toBe("Shift+[");
    expect(press("]", { code: "BracketRight" })).toBe("]");
    expect(press("?", { shiftKey: true })).toBe("?");
    expect(press("/", { code: "Digit7", shiftKey: true })).toBe("/");
    expect(press("Escape")).toBe("Esc");
    expect(press("Enter", { ctrlKey: true })).toBe("Ctrl+Enter");
  });

  it("may stand for several", () => {
    expect(matches(["1–9"], "4")).toBe(true);
    expect(matches(["1–9"], "0")).toBe(false);
    expect(matches(["Ctrl+Shift+Z", "Ctrl+Y"], "Ctrl+Y")).toBe(true);
  });
});

describe("addresses", () => {
  it("name a job and a step", () => {
    expect(parseRoute("#/job/abcdefghijkl/build")).toEqual({ page: "job", id: "abcdefghijkl", step: "build" });
    expect(parseRoute("#/job/abcdefghijkl")).toEqual({ page: "job", id: "abcdefghijkl", step: "parts" });
    for (const hash of ["", "#/", "#/job/short/build", "#/job/abcdefghijkl/else", "#token=x"]) {
      expect(parseRoute(hash)).toEqual({ page: "start" });
    }
    expect(hashOf({ page: "job", id: "abcdefghijkl", step: "build" })).toBe("#/job/abcdefghijkl/build");
  });
});

const picked = (path: string, size = 1): PickedFile => ({
  path,
  file: { name: path.split("/").pop() ?? "", size } as File,
});

describe("files", () => {
  it("get plain names, each once", () => {
    const { files, refused } = nameFiles(
      [
        picked("set/left/bracket.stl"),
        picked("set/right/bracket.stl"),
        picked("set/.DS_Store"),
        picked("set/notes.txt"),
      ],
      100,
    );
    expect(files.map(({ name }) => name)).toEqual(["bracket.stl", "right-bracket.stl"]);
    expect(refused).toEqual([]);
  });

  it("are refused with a reason", () => {
    const { files, refused } = nameFiles([picked("cover.step"), picked("big.stl", 200), picked("readme.md")], 100);
    expect(files).toEqual([]);
    expect(refused.map(({ file, error }) => `${file}: ${error.split(".")[0]}`)).toEqual([
      "cover.step: STEP files are not read",
      "big.stl: The file is larger than this server takes",
      "readme.md: Files of this kind are not read",
    ]);
  });

  it("name a job", () => {
    const now = new Date(2026, 10, 29, 14, 31);
    expect(jobName([picked("Week 48/a.stl"), picked("Week 48/b.stl")], now)).toBe("Week 48");
    expect(jobName([picked("a.stl"), picked("order.csv")], now)).toBe("order");
    expect(jobName([picked("a.stl")], now)).toBe("a");
    expect(jobName([picked("a.stl"), picked("b.stl")], now)).toBe("Build 2026-11-29 14:31");
  });
});

describe("rows in sight", () => {
  it("are those of the window and some around it", () => {
    const heights = new Array<number>(2000).fill(44);
    const sight = sightOf(heights, 44_000, 880, 88);
    expect(sight.first).toBe(998);
    expect(sight.last).toBe(1022);
    expect(sight.before + 44 * (sight.last - sight.first) + sight.after).toBe(2000 * 44);
    expect(sightOf([], 0, 100)).toEqual({ first: 0, last: 0, before: 0, after: 0 });
  });
});
