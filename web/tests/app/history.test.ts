/// Undo and redo.

import { describe, expect, it } from "vitest";
import { History } from "../../src/app/state/history";

function history() {
  const clock = { now: 0 };
  return { clock, own: new History("a", () => clock.now) };
}

describe("undo and redo", () => {
  it("go back and forth", () => {
    const { own } = history();
    own.change("b");
    own.change("c");
    own.undo();
    expect(own.value).toBe("b");
    own.undo();
    expect([own.value, own.canUndo, own.canRedo]).toEqual(["a", false, true]);
    own.undo();
    own.redo();
    own.redo();
    expect([own.value, own.canUndo, own.canRedo]).toEqual(["c", true, false]);
  });

  it("forget what was undone once something else is done", () => {
    const { own } = history();
    own.change("b");
    own.undo();
    own.change("c");
    own.redo();
    expect(own.value).toBe("c");
  });

  it("take what follows closely as one step", () => {
    const { own, clock } = history();
    own.change("b", "count");
    clock.now = 500;
    own.change("c", "count");
    clock.now = 5000;
    own.change("d", "count");
    own.undo();
    expect(own.value).toBe("c");
    own.undo();
    expect(own.value).toBe("a");
  });

  it("do not join what was undone with what comes after", () => {
    const { own } = history();
    own.change("b", "count");
    own.change("c", "gap");
    own.undo();
    own.change("d", "count");
    own.undo();
    expect(own.value).toBe("b");
  });

  it("know nothing of what changes nothing", () => {
    const { own } = history();
    own.change("a");
    expect(own.canUndo).toBe(false);
  });

  it("begin anew with another document", () => {
    const { own } = history();
    own.change("b");
    own.reset("z");
    expect([own.value, own.canUndo]).toEqual(["z", false]);
  });

  it("keep so many steps and no more", () => {
    const own = new History(0, () => 0, 0, 3);
    for (let i = 1; i <= 10; i += 1) own.change(i);
    for (let i = 0; i < 10; i += 1) own.undo();
    expect(own.value).toBe(7);
  });
});
