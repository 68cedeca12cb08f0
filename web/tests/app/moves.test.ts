/// Ways out in words.

import { describe, expect, it } from "vitest";
import { directionWords, pathWords, wayOf } from "../../src/app/words/moves";

const plain = (text: string | null) => text?.replaceAll("\u202f", " ") ?? null;

describe("a way out", () => {
  it("is said by its moves", () => {
    expect(plain(pathWords([[0, 0, 181]]))).toBe("straight up, 181 mm");
    expect(plain(pathWords([[65, 0, 0]]))).toBe("to the right, 65 mm");
    expect(
      plain(
        pathWords([
          [20, 0, 0],
          [0, 0, 140],
        ]),
      ),
    ).toBe("to the right 20 mm, then up 140 mm");
    expect(
      plain(
        pathWords([
          [0, -4, 0],
          [-9.97, 0, 0],
        ]),
      ),
    ).toBe("to the front 4.0 mm, then to the left 10 mm");
  });

  it("is one move where the direction stays", () => {
    expect(
      plain(
        pathWords([
          [0, 0, 30],
          [0, 0, 60],
        ]),
      ),
    ).toBe("straight up, 90 mm");
  });

  it("leaves out moves that no hand makes, unless there are no others", () => {
    expect(
      plain(
        pathWords([
          [0, 0, -0.1],
          [0, 30, 0],
        ]),
      ),
    ).toBe("to the back, 30 mm");
    expect(plain(pathWords([[0, 0, 0.2]]))).toBe("straight up, 0.2 mm");
  });

  it("may be none at all", () => {
    expect(pathWords([])).toBeNull();
    expect(pathWords([[0, 0, 0]])).toBeNull();
    expect(wayOf([])).toBe("none");
  });

  it("leans only where it does so clearly", () => {
    expect(directionWords([1, 0, 20])).toBe("up");
    expect(directionWords([10, 0, 20])).toBe("up and to the right");
    expect(wayOf([[10, 0, 20]])).toBe("slant");
    expect(wayOf([[0, 0, 20]])).toBe("up");
    expect(
      wayOf([
        [0, 0, 20],
        [9, 0, 0],
      ]),
    ).toBe("bend");
  });
});
