/// Turns, boxes, fits, layers and remarks.

import { describe, expect, it } from "vitest";
import { emptyDraft, newPart } from "../../src/app/state/draft";
import { isTooLarge, scaleThatFits } from "../../src/app/state/fits";
import { approximateLayers, fullest, layerAt, plotEnd } from "../../src/app/state/layers";
import { mmPerUnit, partSize, partVolume } from "../../src/app/state/part_size";
import { remarksOf } from "../../src/app/state/remarks";
import { extentOf, standsWords, wayWords } from "../../src/app/state/turns";
import { mesh } from "./mesh";

type M = number[][];
const turn = (axis: 0 | 1 | 2, degrees: number): M => {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const m: M = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
  (m[i] as number[])[i] = c;
  (m[i] as number[])[j] = -s;
  (m[j] as number[])[i] = s;
  (m[j] as number[])[j] = c;
  return m;
};
const times = (a: M, b: M): M =>
  a.map((row) => [0, 1, 2].map((c) => row.reduce((sum, v, k) => sum + v * (b[k]?.[c] ?? 0), 0)));
const placed = (m: M, at = [0, 0, 0], scale = 1): M => [
  ...m.map((row, r) => [...row.map((v) => v * scale), at[r] ?? 0]),
  [0, 0, 0, 1],
];

describe("turns", () => {
  it("are said by the fewest", () => {
    expect(standsWords(placed(turn(0, 0)))).toBe("as drawn");
    expect(standsWords(placed(turn(0, 90)))).toBe("turned 90° about X");
    expect(standsWords(placed(turn(1, 180)))).toBe("turned 180° about Y");
    expect(standsWords(placed(turn(2, -90), [1, 2, 3], 25.4))).toBe("turned −90° about Z");
    expect(standsWords(placed(turn(2, 45)))).toBe("turned 45° about Z");
    expect(standsWords(placed(times(turn(2, 90), turn(0, 90))))).toMatch(/^turned (−?90° about [XYZ](, then )?){2}$/);
  });

  it("come out as they are said, for all right-angled ones", () => {
    const angles = [0, 90, 180, 270];
    for (const x of angles)
      for (const y of angles)
        for (const z of angles) {
          const wanted = times(turn(2, z), times(turn(1, y), turn(0, x)));
          const words = standsWords(placed(wanted));
          let got = turn(0, 0);
          for (const [, sign, degrees, axis] of words.matchAll(/(−?)(\d+)° about ([XYZ])/g)) {
            got = times(turn("XYZ".indexOf(axis ?? "") as 0 | 1 | 2, Number(degrees) * (sign ? -1 : 1)), got);
          }
          expect(got.flat().map((v) => Math.round(v) + 0)).toEqual(wanted.flat().map((v) => Math.round(v) + 0));
          expect(words.split(", then").length).toBeLessThanOrEqual(2);
        }
  });
});

describe("where a copy stands", () => {
  const box = [
    [0, 0, 0],
    [60, 40, 20],
  ];

  it("is its turned box", () => {
    const { low, high } = extentOf(placed(turn(2, 90), [100, 10, 5]), box, null);
    expect([...low, ...high].map((v) => Math.round(v))).toEqual([60, 10, 5, 100, 70, 25]);
  });

  it("goes by the vertices where the turn is not right-angled", () => {
    const positions = new Float32Array([0, 0, 0, 10, 0, 0, 0, 10, 0]);
    const square = [
      [0, 0, 0],
      [10, 10, 0],
    ];
    const { high } = extentOf(placed(turn(2, 45)), square, positions);
    expect(high[1]).toBeCloseTo(Math.SQRT1_2 * 10);
  });

  it("is left in words", () => {
    expect(wayWords([[0, 0, 242]])).toBe("up");
    expect(
      wayWords([
        [0, 0, 5],
        [0, 300, 0],
      ]),
    ).toBe("up, then to the back");
    expect(wayWords([[-9, 1, 1]])).toBe("to the left");
    expect(wayWords([])).toBe("it stands alone by then");
  });
});

describe("parts and the tray", () => {
  const room = [370, 274, 370] as const;

  it("fit by their boxes, as they may stand", () => {
    expect(isTooLarge([360, 370, 20], { kind: "any" }, room)).toBe(false);
    expect(isTooLarge([360, 370, 20], { kind: "fixed" }, room)).toBe(true);
    expect(isTooLarge([270, 360, 20], { kind: "upright" }, room)).toBe(false);
    expect(isTooLarge([20, 360, 360], { kind: "axes", axes: ["+z"], yaw: null }, room)).toBe(false);
    expect(isTooLarge([413, 247, 28], { kind: "any" }, room)).toBe(true);
    expect(scaleThatFits([413, 247, 28], { kind: "any" }, room, 2.8)).toBe(2.5);
    expect(isTooLarge([100, 100, 9000], { kind: "fixed" }, [200, 200, Number.POSITIVE_INFINITY])).toBe(false);
  });

  it("have the size that their unit and scale make", () => {
    const part = { ...newPart("a.stl", null, "a"), unit: "inch" as const, scale: 2 };
    expect(partSize(part, mesh(), emptyDraft)[0]).toBeCloseTo(60 * 50.8);
    expect(partVolume(part, mesh(), emptyDraft)).toBeCloseTo(12_000 * 50.8 ** 3);
    // A file that says its unit keeps it; the server's figures are in mm already.
    const known = mesh({ unit: 25.4, unit_known: true });
    expect(partSize(part, known, emptyDraft)[0]).toBeCloseTo(120);
    expect(mmPerUnit(part, known, emptyDraft)).toBeCloseTo(50.8);
  });

  it("are remarked on in plain words", () => {
    const part = newPart("bracket.stl", null, "b");
    const of = (change: Parameters<typeof mesh>[0], own = part) =>
      remarksOf({ part: own, mesh: mesh(change), draft: emptyDraft, room: [480, 245, 200], reading: false });
    expect(of({})).toEqual([]);
    const small = { size: [1, 2.5, 2], unit_hint: "is 2.5 mm long as it stands" };
    expect(of(small)[0]).toMatchObject({
      tone: "warn",
      text: "Only 2.5 mm long: perhaps drawn in inches.",
      actions: [
        { do: "unit", unit: "inch" },
        { do: "unit", unit: "mm" },
      ],
    });
    expect(of(small, { ...part, unit: "mm" })).toEqual([]);
    expect(of({ size: [500, 400, 300] })[0]?.actions[0]).toMatchObject({ do: "scale", scale: 0.61 });
    expect(of({ repairs: ["merged 12 vertices", "turned 12 facets that faced the wrong way"] })[0]).toMatchObject({
      tone: "info",
      text: "Turned 12 facets that faced the wrong way.",
    });
    expect(of({ warnings: ["is not closed (3 border edges)"] })[0]?.tone).toBe("warn");
    const gone = { part, mesh: null, draft: emptyDraft, room: null };
    expect(remarksOf({ ...gone, reading: false })[0]?.text).toBe("bracket.stl is not there.");
    expect(remarksOf({ ...gone, reading: true })).toEqual([]);
  });
});

describe("layers", () => {
  it("are spread over a copy's height while copies land", () => {
    const body = { extent: { low: [0, 0, 10] as const, high: [10, 10, 30] as const }, volume: 2000 };
    const layers = approximateLayers([body, body], 1000, 100, 10);
    expect(layers.thickness).toBe(10);
    expect(layers.share.map((v) => Number(v.toFixed(3)))).toEqual([0, 0.2, 0.2, 0, 0, 0, 0, 0, 0, 0]);
    expect(layerAt(layers, 15)).toBeCloseTo(0.2);
    expect(fullest(layers).z).toBe(15);
    expect(plotEnd(layers)).toBe(0.3);
  });
});
