/// Numbers, times, jobs, options and reasons in words.

import { describe, expect, it } from "vitest";
import type { Job, Option } from "../../src/api/types";
import { emptyDraft, newPart } from "../../src/app/state/draft";
import { leftOverWords } from "../../src/app/state/left_over";
import { choices, defaultChoice, readOption } from "../../src/app/state/option_values";
import type { LeftOver, Packing, Reason } from "../../src/app/state/packing";
import { figures, stateWords } from "../../src/app/words/jobs";
import { bytes, count, counted, ordinal, parseNumber, percent, size, thin, volume } from "../../src/app/words/numbers";
import { defaultText, helpOf, label } from "../../src/app/words/options";
import { phaseRows } from "../../src/app/words/phases";
import { ago, clock, due, duration } from "../../src/app/words/times";

describe("numbers", () => {
  it("stand apart from their units by a thin space", () => {
    expect(percent(0.1564)).toBe(`15.6${thin}%`);
    expect(bytes(1_234_000_000)).toBe(`1.2${thin}GB`);
    expect(bytes(61_200_000)).toBe(`61${thin}MB`);
    expect(count(3598)).toBe(`3${thin}598`);
    expect(volume(28_600)).toBe(`28.6${thin}cm³`);
    expect(volume(7_900_000)).toBe("7.9 litres");
  });

  it("say sizes as finely as it takes", () => {
    expect(size([62, 84.5, 20])).toBe(`62 × 85 × 20${thin}mm`);
    expect(size([62, 84.5, 20], true)).toBe(`62.0 × 84.5 × 20.0${thin}mm`);
    expect(size([2.9, 7.6, 4.8])).toBe(`2.9 × 7.6 × 4.8${thin}mm`);
    expect(size([25.4, 50.8, 12.7], true, "inch")).toBe(`1.00 × 2.00 × 0.50${thin}in`);
  });

  it("count", () => {
    expect([1, 2, 3, 11, 44, 112].map(ordinal)).toEqual(["1st", "2nd", "3rd", "11th", "44th", "112th"]);
    expect(counted(1, "part")).toBe("1 part");
    expect(counted(2, "copy", "copies")).toBe("2 copies");
  });

  it("are read as people type them", () => {
    expect(["3,5", "1 200", ".5", "1e3", "-2"].map(parseNumber)).toEqual([3.5, 1200, 0.5, 1000, -2]);
    expect(["", "x", "1,2,3", "1.2.3"].map(parseNumber)).toEqual([null, null, null, null]);
  });
});

describe("times", () => {
  it("say how long", () => {
    expect([0.3, 15, 90, 300, 4800].map(duration)).toEqual(
      ["0.3 s", "15 s", "90 s", "5 min", "1 h 20 min"].map((text) => text.replace(/(\d) ([a-z])/g, `$1${thin}$2`)),
    );
    expect([9, 760, 3723].map(clock)).toEqual(["0:09", "12:40", "1:02:03"]);
  });

  it("say when", () => {
    const now = new Date(2026, 10, 29, 15, 0, 0);
    expect(ago(new Date(2026, 10, 29, 14, 59, 30), now)).toBe("now");
    expect(ago(new Date(2026, 10, 29, 9, 5), now)).toBe("09:05");
    expect(ago(new Date(2026, 10, 28, 23, 59), now)).toBe("yesterday");
    expect(ago(new Date(2026, 10, 25), now)).toBe("25 Nov");
    expect(due("2026-12-02", now)).toBe("2 Dec");
    expect(due("2027-01-15", now)).toBe("15 Jan");
    expect(due("2028-01-15", now)).toBe("15 Jan 2028");
  });
});

const job: Job = {
  id: "abcdefghijkl",
  name: "Week 48",
  created: "2026-11-29T14:00:00Z",
  changed: "2026-11-29T14:31:50Z",
  started: "2026-11-29T14:31:35Z",
  status: "done",
  stopping: false,
  has_job_file: true,
  can_improve: true,
  revision: 1,
  revisions: [],
  files: 23,
  bytes: 1,
  queue_place: null,
  error: null,
  remarks: [],
  has_packing: true,
  has_picture: true,
  tray: "HP Jet Fusion 5200",
  progress: null,
  summary: {
    copies: 238,
    placed: 222,
    trays: 1,
    density: 0.1564,
    height: 375,
    min_gap: 3,
    seconds: 15,
    improvement: null,
  },
  verdict: { ok: true, apart: "checked", steps: 220, min_gap: 3, findings: [] },
};

describe("jobs", () => {
  it("say how they stand", () => {
    expect(stateWords(job)).toEqual({ tone: "ok", text: "Comes apart" });
    expect(stateWords({ ...job, status: "queued", queue_place: 2 }).text).toBe("Waiting: place 2");
    expect(stateWords({ ...job, status: "interrupted" }).tone).toBe("warn");
    const progress = { phase: "search", done: 97, total: 156, seconds: 30, left: 20 } as const;
    const running: Job = { ...job, status: "running", progress };
    expect(stateWords(running).text).toBe(`Packing 62${thin}%`);
    expect(figures(running)).toBe(`97 of 156 placed · about 20${thin}s left`);
    expect(figures(job)).toBe(`222 of 238 copies · 15.6${thin}% full`);
    expect(figures({ ...job, status: "failed", error: "It ran out of memory." })).toBe("It ran out of memory.");
  });

  it("tell a check that failed from one that was not made", () => {
    const verdict = { ok: false, apart: "no", steps: 0, min_gap: 3, findings: [] } as const;
    expect(stateWords({ ...job, verdict: { ...verdict, findings: [] } }).text).toBe("Does not come apart");
    expect(stateWords({ ...job, verdict: { ...verdict, findings: [], ok: true, apart: "not_checked" } }).tone).toBe(
      "warn",
    );
  });
});

describe("phases", () => {
  it("are done, now, or to come", () => {
    const rows = phaseRows(new Set(["load", "search"]), "search", 23);
    expect(rows.map((row) => [row.text, row.state])).toEqual([
      ["Read 23 parts", "done"],
      ["Place copies, slide them together", "now"],
      ["Check that it comes apart", "wait"],
      ["Measure every gap", "wait"],
    ]);
  });

  it("are shown once they begin, where most runs do not have them", () => {
    const rows = phaseRows(new Set(["load", "search", "disassemble", "reinsert"]), "disassemble", 1);
    expect(rows.find((row) => row.phase === "reinsert")).toBeDefined();
    expect(rows.find((row) => row.phase === "improve")).toBeUndefined();
  });
});

const option = (change: Partial<Option>): Option => ({
  name: "max-layer-fill",
  group: "packing",
  type: "number",
  above: true,
  words: [],
  none_word: "",
  zero_word: "",
  placeholder: "F",
  line: "at most this share of each layer, like 0.4",
  help: "As --max-density, for every layer by itself.",
  values: "a number above 0 and at most 1",
  default: "",
  examples: [],
  optional: true,
  here: true,
  least: 0,
  most: 1,
  ...change,
});

describe("options", () => {
  it("are named and explained without the command line's dashes", () => {
    expect(label("max-layer-fill")).toBe("Max layer fill");
    expect(helpOf(option({}))).toBe(
      "At most this share of each layer, like 0.4. As “max density”, for every layer by itself.",
    );
    expect(helpOf(option({ help: "'auto' is the paper's. A copy's 'own'." }))).toContain(
      "“auto” is the paper’s. A copy’s “own”.",
    );
    expect(defaultText(option({ default: "2: perhaps 1 with --improve" }))).toBe("2: perhaps 1 with “improve”");
  });

  it("take what the program takes", () => {
    expect(readOption(option({}), "0,4")).toEqual({ value: 0.4 });
    expect(readOption(option({}), "")).toEqual({ value: undefined });
    expect(readOption(option({}), "0")).toHaveProperty("problem");
    expect(readOption(option({}), "1.1")).toHaveProperty("problem");
    expect(readOption(option({ type: "integer", most: 9, least: 1, above: false }), "2.5")).toHaveProperty("problem");
    expect(readOption(option({ zero_word: "rest" }), "rest")).toEqual({ value: "rest" });
    const memory = option({ type: "bytes", least: 0, most: 1e15, above: false });
    expect(readOption(memory, "4G")).toEqual({ value: 4_000_000_000 });
    expect(readOption(memory, "2Gi")).toEqual({ value: 2_147_483_648 });
    expect(readOption(memory, "soon")).toHaveProperty("problem");
  });

  it("offer their words and the one for none", () => {
    const unpack = option({
      type: "word",
      words: ["any", "top"],
      none_word: "auto",
      default: "auto: top; any in a mesh",
    });
    expect(choices(unpack)).toEqual(["auto", "any", "top"]);
    expect(defaultChoice(unpack)).toBe("auto");
    expect(defaultChoice(option({ type: "word", words: ["post"], default: "post" }))).toBe("post");
  });
});

describe("what was left over", () => {
  const packing = { trays: [{}], openHeight: false } as unknown as Packing;
  const row = (reason: Reason, detail = ""): LeftOver => ({
    part: 0,
    reason,
    copies: 3,
    detail,
    which: [0, 1, 2],
    byHand: false,
  });
  const draft = { ...emptyDraft, parts: [{ ...newPart("a.stl", null, "a.stl"), stands: { kind: "fixed" as const } }] };
  const words = (own: LeftOver, by = draft) => leftOverWords(own, packing, by, "a.stl");

  it("wants another tray where there is no place left", () => {
    const { text, remedy } = words(row("no_place"));
    expect(text).toBe("No free place left.");
    expect(remedy).toMatchObject({ text: "Pack again with 2 trays", draft: { trays: 2 } });
    expect(words(row("no_place"), { ...draft, trays: "all" }).remedy.draft).toBeNull();
  });

  it("says what is too large, and what would do", () => {
    const sizes = "413 x 247 x 28 mm, and there is room for 370 x 274 x 370 mm";
    expect(words(row("too_large", sizes))).toMatchObject({
      text: `413 × 247 × 28${thin}mm; the tray takes 370 × 274 × 370${thin}mm.`,
      remedy: { text: "Change the part", draft: null },
    });
    expect(words(row("too_large", `${sizes}. It fits with --rotations 45`)).remedy.draft?.options).toEqual({
      rotations: "45",
    });
    expect(words(row("too_large", `${sizes}. It fits into EOS P 396: --printer eos-p396`)).remedy.draft?.tray).toEqual({
      kind: "printer",
      name: "eos-p396",
    });
    const free = `${sizes}. It fits where it may be turned as --rotations says, and not just as its orientations do`;
    expect(words(row("too_large", free)).remedy.draft?.parts[0]?.stands).toEqual({ kind: "any" });
  });

  it("gives more time, and lifts caps", () => {
    expect(words(row("not_tried"), { ...draft, timeLimit: 300 }).remedy).toMatchObject({
      text: `Pack again with 10${thin}min`,
      draft: { timeLimit: 600 },
    });
    const capped = { ...draft, options: { "max-density": 0.3 } };
    expect(words(row("cap", "0.3"), capped)).toMatchObject({
      text: `The tray may be filled to 30${thin}% only.`,
      remedy: { draft: { options: {} } },
    });
  });
});
