/// Whether a part fits the tray at all, by its box. It is what the page can tell at once; the server's estimate knows
/// finer turns as well.

import type { Sides, Stands } from "./draft";

/// Sides of the part's box in the ways that its right-angled turns allow.
function boxes(size: Sides, stands: Stands): Sides[] {
  const [x, y, z] = size;
  const turned = (a: number, b: number, up: number): Sides[] => [
    [a, b, up],
    [b, a, up],
  ];
  switch (stands.kind) {
    case "fixed":
      return [size];
    case "upright":
      return turned(x, y, z);
    case "axes":
      return stands.axes.flatMap((axis) =>
        axis.endsWith("x") ? turned(y, z, x) : axis.endsWith("y") ? turned(x, z, y) : turned(x, y, z),
      );
    default:
      return [...turned(x, y, z), ...turned(y, z, x), ...turned(x, z, y)];
  }
}

/// The largest factor by which the part may grow and still fit; under 1 it is too large as it is.
export function roomToGrow(size: Sides, stands: Stands, room: Sides): number {
  const factor = (box: Sides) =>
    Math.min(...box.map((side, axis) => (side > 0 ? (room[axis] ?? 0) / side : Number.POSITIVE_INFINITY)));
  return Math.max(...boxes(size, stands).map(factor));
}

const slack = 1e-9;

export function isTooLarge(size: Sides, stands: Stands, room: Sides): boolean {
  return roomToGrow(size, stands, room) < 1 - slack;
}

/// The scale that fits, whole percents, or null where none does.
export function scaleThatFits(size: Sides, stands: Stands, room: Sides, scale: number): number | null {
  const percents = Math.floor(roomToGrow(size, stands, room) * scale * 100 + slack);
  return percents >= 1 ? percents / 100 : null;
}

/// Turns by other than right angles may fit where these do not.
export function onlyRightAngles(rotations: unknown): boolean {
  return rotations === undefined || rotations === "90" || rotations === 90 || rotations === "none";
}
