/// Changes by hand: what they make of a packing, on their way to the server, and taken back.

import { beforeEach, describe, expect, it, vi } from "vitest";
import { ApiError } from "../../src/api/client";
import { BuildHistory } from "../../src/app/change/build_history";
import { applyChanges, type CopyChange, inverseOf, merged, placementOf } from "../../src/app/change/change";
import { ChangeQueue, type QueueHost } from "../../src/app/change/queue";
import { namedCopies } from "../../src/app/words/named";
import { at, packingOf } from "./packing_of";

const change = (part: number, copy: number, x: number | null, tray = 1): CopyChange => ({
  tray,
  part,
  copy,
  transform: x === null ? null : at(x),
});

describe("a changed packing", () => {
  const packing = packingOf([
    [0, 0, 10],
    [0, 1, 20],
    [1, 0, 30],
  ]);

  it("is without the copy that is taken out, which is left over by hand", () => {
    const changed = applyChanges(packing, [change(0, 1, null)]);
    expect(changed.trays[0]?.placements.map(({ part, copy }) => [part, copy])).toEqual([
      [0, 0],
      [1, 0],
    ]);
    expect(changed.placed).toBe(2);
    expect(changed.leftOver).toEqual([
      { part: 0, reason: "not_tried", copies: 1, detail: "taken out by hand", which: [1], byHand: true },
    ]);
    expect(changed.density).toBeCloseTo(packing.density * (1.5 / 2.5));
    // The others keep their numbers: the server knows them by these.
    expect(changed.trays[0]?.byId.get("1/0")?.index).toBe(2);
  });

  it("has one row for several copies, and none once all are back", () => {
    const out = applyChanges(packing, [change(0, 0, null), change(0, 1, null)]);
    expect(out.leftOver.map(({ which }) => which)).toEqual([[0, 1]]);
    const back = applyChanges(out, [change(0, 0, 10), change(0, 1, 20)]);
    expect(back.leftOver).toEqual([]);
    expect(back.placed).toBe(3);
  });

  it("forgets the way out of a copy that was moved, and of no other", () => {
    const changed = applyChanges(packing, [change(0, 0, 55)]);
    expect(placementOf(changed, { tray: 1, part: 0, copy: 0 })).toMatchObject({ step: null, transform: at(55) });
    expect(placementOf(changed, { tray: 1, part: 1, copy: 0 })?.step).toBe(1);
  });

  it("is the same one without changes", () => {
    expect(applyChanges(packing, [])).toBe(packing);
  });

  it("comes back by the inverse", () => {
    const changes = [change(0, 0, null), change(0, 1, 25), change(1, 0, 35)];
    const changed = applyChanges(packing, changes);
    const back = applyChanges(changed, inverseOf(packing, changes));
    const places = (own: typeof packing) =>
      [...(own.trays[0]?.byId ?? [])].map(([id, { transform }]) => [id, transform]).sort();
    expect(places(back)).toEqual(places(packing));
    expect(inverseOf(changed, [change(0, 0, 10)])).toEqual([change(0, 0, null)]);
  });
});

describe("changes together", () => {
  it("have the last word of each copy, said last", () => {
    const all = merged([change(0, 0, 1), change(0, 1, 2)], [change(0, 0, 3)]);
    expect(all).toEqual([change(0, 1, 2), change(0, 0, 3)]);
  });
});

describe("the queue", () => {
  let free: boolean;
  let posts: CopyChange[][];
  let answers: ((error?: unknown) => void)[];
  let host: QueueHost & { refusals: string[] };
  let queue: ChangeQueue;

  beforeEach(() => {
    vi.useFakeTimers();
    free = true;
    posts = [];
    answers = [];
    host = {
      refusals: [],
      free: () => free,
      send: (changes) => {
        posts.push([...changes]);
        return new Promise((done, failed) => {
          answers.push((error) => (error ? failed(error) : done()));
        });
      },
      changed: () => {},
      sending: () => {},
      taken: () => {},
      refused: (sentence) => host.refusals.push(sentence),
    };
    queue = new ChangeQueue(host);
  });

  const settle = () => vi.advanceTimersByTimeAsync(0);

  it("sends the first at once, and together what came meanwhile", async () => {
    queue.add([change(0, 0, null)]);
    expect(posts).toEqual([[change(0, 0, null)]]);
    queue.add([change(0, 1, 5)]);
    queue.add([change(1, 0, 6)]);
    expect(posts).toHaveLength(1);
    free = false;
    answers[0]?.();
    await settle();
    expect(queue.unsent).toEqual([change(0, 1, 5), change(1, 0, 6)]);
    expect(queue.pending).toHaveLength(3);
    // The check is over, and its packing came.
    free = true;
    queue.loaded();
    void queue.next();
    expect(posts[1]).toEqual([change(0, 1, 5), change(1, 0, 6)]);
    expect(queue.pending).toHaveLength(2);
  });

  it("drops all that waits when the server refuses, and says its sentence", async () => {
    queue.add([change(0, 0, 1)]);
    queue.add([change(0, 1, 2)]);
    answers[0]?.(new ApiError("Bracket 1 would touch mug 2.", 400));
    await settle();
    expect(host.refusals).toEqual(["Bracket 1 would touch mug 2."]);
    expect(queue.pending).toEqual([]);
  });

  it("asks again where the server is busy", async () => {
    queue.add([change(0, 0, 1)]);
    answers[0]?.(new ApiError("Busy.", 503));
    await settle();
    expect([host.refusals, queue.unsent]).toEqual([[], [change(0, 0, 1)]]);
    await vi.advanceTimersByTimeAsync(2000);
    expect(posts).toHaveLength(2);
  });
});

describe("undo and redo of the build", () => {
  const entry = (x: number) =>
    ({
      kind: "changes",
      does: [change(0, 0, x)],
      undoes: [change(0, 0, 0)],
      before: new Set<string>(),
      after: new Set<string>(),
    }) as const;

  it("go back and forth, and forget the future once something is done", () => {
    const own = new BuildHistory();
    own.push(entry(1));
    own.push(entry(2));
    expect(own.undo()).toEqual(entry(2));
    expect(own.redo()).toEqual(entry(2));
    own.undo();
    own.push(entry(3));
    expect(own.redo()).toBeNull();
    expect(own.last).toEqual(entry(3));
  });

  it("go back to what the server has", () => {
    const own = new BuildHistory();
    own.push(entry(1));
    const lists = own.now;
    own.push(entry(2));
    own.undo();
    own.restore(lists);
    expect([own.last, own.next]).toEqual([entry(1), null]);
  });

  it("learn of a packing once it is done", () => {
    const own = new BuildHistory();
    const locks = new Set<string>();
    const before = { number: 3, locks, packed: null };
    const packed = { kind: "pack", before, after: null } as const;
    own.push(packed);
    own.undo();
    own.replace(packed, { ...packed, after: { ...before, number: 4 } });
    expect(own.redo()).toMatchObject({ after: { number: 4 } });
    own.replace(own.last ?? packed, null);
    expect(own.last).toBeNull();
  });
});

describe("the program's sentences", () => {
  const packing = packingOf([
    [0, 0, 10],
    [0, 1, 20],
    [1, 0, 30],
  ]);

  it("name copies as the page does", () => {
    expect(namedCopies("2 bracket and 3 lid overlap, at least 2.02 mm deep", packing)).toBe(
      "bracket 2 and lid 1 overlap, at least 2.02 mm deep",
    );
  });

  it("stay as they are where a number is of no copy", () => {
    const text = "9 bracket and 2 mug overlap by 1.2 lid";
    expect(namedCopies(text, packing)).toBe(text);
    expect(namedCopies(text, null)).toBe(text);
  });
});
