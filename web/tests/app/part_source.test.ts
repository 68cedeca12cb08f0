/// When files are handed on.

import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { api } from "../../src/api/client";
import type { Parts } from "../../src/api/types";
import { PartSource } from "../../src/app/state/part_source";

const holding = (...files: string[]): Parts => ({
  reading: 0,
  meshes: files.map((file) => ({ file })) as unknown as Parts["meshes"],
  bad: [],
  sets: [],
});

let taken: string[];
let sending: boolean;
let answers: ((parts: Parts) => void)[];
let source: PartSource;

/// What the server answers to what it was asked first, and what follows from it.
async function answer(parts: Parts): Promise<void> {
  answers.shift()?.(parts);
  await vi.advanceTimersByTimeAsync(0);
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("window", globalThis);
  taken = [];
  sending = false;
  answers = [];
  vi.spyOn(api, "parts").mockImplementation(() => new Promise((resolve) => answers.push(resolve)));
  source = new PartSource(
    "job",
    () => sending,
    (_, fresh) => taken.push(...fresh),
  );
});

afterEach(() => {
  source.close();
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

describe("a file", () => {
  it("is handed on once the server knows it", async () => {
    source.add("nut.stl");
    await vi.advanceTimersByTimeAsync(150);
    await answer({ ...holding(), reading: 1 });
    expect(taken).toEqual([]);
    await vi.advanceTimersByTimeAsync(600);
    await answer(holding("nut.stl"));
    expect(taken).toEqual(["nut.stl"]);
  });

  it("that arrives while the server is asked is asked for again", async () => {
    sending = true;
    source.addAll();
    await vi.advanceTimersByTimeAsync(0);
    source.add("nut.stl");
    sending = false;
    await answer(holding());
    await vi.advanceTimersByTimeAsync(600);
    await answer(holding("nut.stl"));
    expect(taken).toEqual(["nut.stl"]);
  });

  it("that arrives after the last was sent is not forgotten either", async () => {
    source.addAll();
    await vi.advanceTimersByTimeAsync(0);
    source.add("nut.stl");
    await answer(holding());
    await vi.advanceTimersByTimeAsync(600);
    await answer(holding("nut.stl"));
    expect(taken).toEqual(["nut.stl"]);
  });

  it("that will not come is not waited for", async () => {
    source.add("gone.stl");
    await vi.advanceTimersByTimeAsync(150);
    await answer(holding());
    await vi.advanceTimersByTimeAsync(60_000);
    expect(api.parts).toHaveBeenCalledTimes(1);
  });
});
