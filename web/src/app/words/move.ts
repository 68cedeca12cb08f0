/// What is said of a copy that is moved by hand: how near it is to what, and whether it may stay there.

import type { Clearance } from "../../api/types";
import { thin } from "./numbers";

export type Naming = (copy: { readonly part: number; readonly copy: number }) => string;

export interface Judgement {
  readonly tone: "ok" | "bad";
  readonly bold: string;
  readonly text: string;
}

const sides: Readonly<Record<string, string>> = {
  left: "left wall",
  right: "right wall",
  front: "front wall",
  back: "back wall",
  bottom: "bottom",
  top: "top",
};

/// The server's word, on the exact meshes.
export function judged(clearance: Clearance, name: Naming): Judgement {
  const { nearest, wall } = clearance;
  if (clearance.clear) return { tone: "ok", bold: "It may stand here.", text: "Every gap is kept." };
  const wallLack = wall ? wall.gap - wall.distance : 0;
  const copyLack = nearest ? nearest.gap - nearest.distance : 0;
  if (wall && wallLack > 0 && wallLack >= copyLack) return walled(wall);
  if (nearest && copyLack > 0) {
    const own = name(nearest);
    if (nearest.distance <= 0) return { tone: "bad", bold: `Touches ${own}.`, text: asked(nearest.gap) };
    return { tone: "bad", bold: `Too close to ${own}.`, text: lacking(nearest.distance, nearest.gap) };
  }
  return { tone: "bad", bold: "It cannot stand here.", text: "It reaches out of the tray or into a keep-out." };
}

function walled({ side, distance, gap }: NonNullable<Clearance["wall"]>): Judgement {
  const own = sides[side] ?? side;
  if (distance < 0) {
    return { tone: "bad", bold: "Outside the tray.", text: `It sticks out at the ${own} by ${length(-distance, 1)}.` };
  }
  return { tone: "bad", bold: `Too close to the ${own}.`, text: lacking(distance, gap) };
}

/// Before the server has answered: what it touches on the page's own meshes.
export function touched(copies: readonly { part: number; copy: number }[], name: Naming, outside: boolean): Judgement {
  if (outside) return { tone: "bad", bold: "Outside the tray.", text: "It sticks out of the tray." };
  const [first] = copies;
  const others = copies.length - 1;
  const more = others > 0 ? ` and ${others} more` : "";
  return { tone: "bad", bold: `Touches ${first ? name(first) : "another copy"}${more}.`, text: "The gap is measured." };
}

const length = (value: number, digits: number): string => `${value.toFixed(digits)}${thin}mm`;
const asked = (gap: number): string => (gap > 0 ? `A gap of ${length(gap, 1)} is asked for.` : "Move it farther away.");

/// As many digits as it takes to see that it is less.
function lacking(distance: number, gap: number): string {
  const digits = [1, 2, 3].find((own) => distance.toFixed(own) !== gap.toFixed(own)) ?? 4;
  return `The gap is ${length(distance, digits)}; ${length(gap, digits)} is asked for.`;
}

/// "+18.0", "−9.0", "0.0": how far it was moved along an axis.
export function movedBy(value: number): string {
  const text = Math.abs(value).toFixed(1);
  if (text === "0.0") return text;
  return `${value < 0 ? "−" : "+"}${text}`;
}
