/// The part palette and the ramps of the design: which colour a part, a copy and a value have.

import { hexOfRgb, mix, oklchOfRgb, type Rgb, rgbOfHex, rgbOfOklch } from "./colour";
import type { Theme } from "./view";

/// Consecutive entries differ in hue and lightness. The order is the design's.
export const palette: readonly string[] = [
  "#69a3cb",
  "#edc06b",
  "#3e9790",
  "#e7917a",
  "#826bb3",
  "#c7d787",
  "#e496b5",
  "#99d6e3",
  "#a6603a",
  "#a9e4ca",
  "#48658b",
  "#e5d6b6",
  "#955b85",
  "#609562",
  "#cab7e3",
  "#7d8792",
];

/// From the 17th part on the round starts again, turned by so many degrees and so much darker. After a few rounds it is
/// as light as at first, or a thousand parts would end in black.
const roundTurn = 19;
const roundDarker = 0.03;
const darkerRounds = 4;

/// Copies of a part differ by at most so much, so that two that touch can be told apart.
const copyLightness = 0.025;
const copyHue = 4;

/// Fractional parts of multiples of these two are spread evenly (the plastic number's R2 sequence).
const spread1 = 0.7548776662466927;
const spread2 = 0.5698402909980532;

function partRgb(index: number): Rgb {
  const base = rgbOfHex(palette[index % palette.length] ?? "#7d8792");
  const round = Math.floor(index / palette.length);
  if (round === 0) return base;
  const { lightness, chroma, hue } = oklchOfRgb(base);
  return rgbOfOklch({
    lightness: lightness - roundDarker * (round % darkerRounds),
    chroma,
    hue: hue + roundTurn * round,
  });
}

/// `#rrggbb`. Both themes share the palette; the parameter is there for those that may not.
export function partColour(index: number, _theme?: Theme): string {
  return hexOfRgb(partRgb(index));
}

/// The colour of one copy, in linear light.
export function copyRgb(part: number, copy: number): Rgb {
  const { lightness, chroma, hue } = oklchOfRgb(partRgb(part));
  const between = (v: number) => 2 * (v - Math.floor(v)) - 1;
  return rgbOfOklch({
    lightness: lightness + copyLightness * between(0.5 + copy * spread1),
    chroma,
    hue: hue + copyHue * between(0.5 + copy * spread2),
  });
}

export type Ramp = "one-hue" | "height";

const ramps: Record<Ramp, readonly [Rgb, Rgb]> = {
  "one-hue": [rgbOfHex("#dbe5fb"), rgbOfHex("#1f3f96")],
  height: [rgbOfHex("#f3e7c4"), rgbOfHex("#2f6f6a")],
};

/// `share` 0 to 1, in linear light.
export function rampRgb(ramp: Ramp, share: number): Rgb {
  const [from, to] = ramps[ramp];
  return mix(from, to, Math.min(1, Math.max(0, share)));
}

/// What a legend shows of a ramp, from least to greatest.
export function rampColours(ramp: Ramp, stops = 5): string[] {
  return Array.from({ length: stops }, (_, i) => hexOfRgb(rampRgb(ramp, i / (stops - 1))));
}
