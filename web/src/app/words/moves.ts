/// How copies move out, in words: "straight up, 181 mm", "to the right 20 mm, then up 140 mm".

import { thin } from "./numbers";

type Move = readonly [number, number, number];

/// A direction has a second word where it leans by more than this from the first (15°).
const leans = Math.sin(Math.PI / 12);

const names: readonly (readonly [string, string])[] = [
  ["to the right", "to the left"],
  ["to the back", "to the front"],
  ["up", "down"],
];

const lengthOf = (move: Move): number => Math.hypot(move[0], move[1], move[2]);

/// "up", "up and to the right".
export function directionWords(move: Move): string {
  const length = lengthOf(move) || 1;
  return move
    .map((part, axis) => ({ share: Math.abs(part) / length, text: names[axis]?.[part < 0 ? 1 : 0] ?? "" }))
    .filter(({ share }) => share > leans)
    .sort((a, b) => b.share - a.share)
    .map(({ text }) => text)
    .join(" and ");
}

export function lengthWords(mm: number): string {
  return `${mm.toFixed(mm < 9.95 ? 1 : 0)}${thin}mm`;
}

/// No hand makes a shorter move than this, in mm, on purpose.
const leastMove = 0.5;

/// Moves of one direction that follow each other are one move; those too short to be made are left out where there are
/// others.
function merged(path: readonly Move[]): { readonly text: string; readonly length: number }[] {
  const moves: { text: string; length: number }[] = [];
  const least = path.some((move) => lengthOf(move) >= leastMove) ? leastMove : Number.MIN_VALUE;
  for (const move of path) {
    const length = lengthOf(move);
    const text = directionWords(move);
    const last = moves[moves.length - 1];
    if (length < least) continue;
    if (last?.text === text) last.length += length;
    else moves.push({ text, length });
  }
  return moves;
}

/// Of a whole path; null where it does not move because nothing is left around it.
export function pathWords(path: readonly Move[]): string | null {
  const moves = merged(path);
  const [only] = moves;
  if (!only) return null;
  if (moves.length > 1) return moves.map(({ text, length }) => `${text} ${lengthWords(length)}`).join(", then ");
  const straight = only.text === "up" || only.text === "down" ? "straight " : "";
  return `${straight}${only.text}, ${lengthWords(only.length)}`;
}

/// What a small arrow shows of a path.
export type Way = "up" | "down" | "left" | "right" | "back" | "front" | "slant" | "bend" | "none";

export function wayOf(path: readonly Move[]): Way {
  const moves = merged(path);
  const [only] = moves;
  if (!only) return "none";
  if (moves.length > 1) return "bend";
  const way = { up: "up", down: "down", "to the left": "left", "to the right": "right" }[only.text];
  if (way) return way as Way;
  return only.text === "to the back" ? "back" : only.text === "to the front" ? "front" : "slant";
}
