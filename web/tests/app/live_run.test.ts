/// A run from its lines.

import { beforeEach, describe, expect, it } from "vitest";
import { LiveRun } from "../../src/app/state/live_run";

const at = (x: number) => [
  [1, 0, 0, x],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];
const event = (name: string, part = 0, copy = 0, x = 0, tray = 1) => ({
  event: name,
  tray,
  part,
  copy,
  orientation: 0,
  transform: at(x),
});

let run: LiveRun;

beforeEach(() => {
  run = new LiveRun();
  run.apply({ event: "tray_begun", tray: 1 });
});

describe("a run", () => {
  it("holds what stands", () => {
    run.apply(event("copy_placed", 0, 0));
    run.apply(event("copy_placed", 0, 1, 5));
    run.apply(event("copy_placed", 1, 0));
    run.apply(event("copy_taken_out", 0, 1));
    run.apply(event("copy_moved", 0, 0, 9));
    expect(run.standing).toBe(2);
    expect([...run.counts()]).toEqual([
      [0, 1],
      [1, 1],
    ]);
    expect(run.trays.get(1)?.copies.get("0/0")?.transform[0]?.[3]).toBe(9);
    // The order is that of placing, also of one that was moved.
    expect(run.trays.get(1)?.copies.get("0/0")?.order).toBe(0);
    expect(run.newest?.copy.part).toBe(1);
  });

  it("tells what changed since it was asked", () => {
    run.drain(1);
    run.apply(event("copy_placed", 0, 0));
    run.apply(event("copy_placed", 0, 1));
    run.apply(event("copy_taken_out", 0, 1));
    const { cleared, placed, removed } = run.drain(1);
    expect(cleared).toBe(false);
    expect(placed.map((copy) => copy.copy)).toEqual([0]);
    expect(removed).toEqual([{ part: 0, copy: 1 }]);
    expect(run.drain(1)).toEqual({ cleared: false, placed: [], removed: [] });
    expect(run.drain(1, true).placed).toHaveLength(1);
  });

  it("empties a tray that begins anew", () => {
    run.apply(event("copy_placed"));
    run.drain(1);
    run.apply({ event: "tray_begun", tray: 1 });
    run.apply(event("copy_placed", 2, 0));
    const { cleared, placed } = run.drain(1);
    expect(cleared).toBe(true);
    expect(placed.map((copy) => copy.part)).toEqual([2]);
    expect(run.standing).toBe(1);
  });

  it("fills several trays", () => {
    run.apply(event("copy_placed"));
    run.apply({ event: "tray_finished", tray: 1 });
    run.apply({ event: "tray_begun", tray: 2 });
    run.apply(event("copy_placed", 0, 1, 0, 2));
    expect(run.current).toBe(2);
    expect(run.trays.get(1)?.finished).toBe(true);
    expect(run.trays.get(2)?.finished).toBe(false);
  });

  it("knows its phases, remarks and progress", () => {
    run.apply({ phase: "load", done: 3, total: 3, density: null, seconds: 0.2, left: 0 });
    run.apply({ phase: "search", done: 12, total: 300, density: 0.2, seconds: 1.5, left: 30.1 });
    run.apply({ warning: "jig is larger than the tray" });
    run.apply({ warning: "jig is larger than the tray" });
    run.apply({ error: "a.stl: no such file" });
    expect([...run.phases]).toEqual(["load", "search"]);
    expect(run.seconds.get("load")).toBe(0.2);
    expect(run.progress?.left).toBe(30.1);
    expect(run.remarks).toEqual(["jig is larger than the tray", "a.stl: no such file"]);
  });

  it("does not mind what it does not know", () => {
    const { version } = run;
    for (const line of [null, 3, "x", {}, { event: "else" }, { event: "copy_placed", tray: 1 }]) run.apply(line);
    expect(run.standing).toBe(0);
    expect(run.version).toBeGreaterThan(version);
  });

  it("forgets the run before", () => {
    run.apply(event("copy_placed"));
    run.clear();
    expect([run.standing, run.newest, run.progress]).toEqual([0, null, null]);
    expect(run.drain(1).cleared).toBe(true);
  });
});
