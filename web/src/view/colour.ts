/// Colours as numbers: `#rrggbb`, linear light and OKLCH, where equal steps look equal.
/// The matrices are Björn Ottosson's (https://bottosson.github.io/posts/oklab).

/// Linear light, 0 to 1 each.
export type Rgb = readonly [number, number, number];

export interface Oklch {
  /// 0 black to 1 white
  readonly lightness: number;
  readonly chroma: number;
  /// degrees
  readonly hue: number;
}

function decode(v: number): number {
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
}

function encode(v: number): number {
  return v <= 0.0031308 ? v * 12.92 : 1.055 * v ** (1 / 2.4) - 0.055;
}

export function rgbOfHex(hex: string): Rgb {
  const n = Number.parseInt(hex.slice(1), 16);
  return [decode((n >> 16) / 255), decode(((n >> 8) & 255) / 255), decode((n & 255) / 255)];
}

export function hexOfRgb(rgb: Rgb): string {
  const byte = (v: number) =>
    Math.round(255 * encode(Math.min(1, Math.max(0, v))))
      .toString(16)
      .padStart(2, "0");
  return `#${byte(rgb[0])}${byte(rgb[1])}${byte(rgb[2])}`;
}

function oklabOfRgb([r, g, b]: Rgb): Rgb {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function rgbOfOklab([lightness, a, b]: Rgb): Rgb {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

export function oklchOfRgb(rgb: Rgb): Oklch {
  const [lightness, a, b] = oklabOfRgb(rgb);
  return { lightness, chroma: Math.hypot(a, b), hue: (Math.atan2(b, a) * 180) / Math.PI };
}

function shown(rgb: Rgb): boolean {
  return rgb.every((v) => v >= -1e-4 && v <= 1 + 1e-4);
}

/// The colour that a screen can show nearest to the one asked for: of the same lightness and hue, with less chroma.
export function rgbOfOklch({ lightness, chroma, hue }: Oklch): Rgb {
  const angle = (hue * Math.PI) / 180;
  const light = Math.min(1, Math.max(0, lightness));
  const at = (c: number) => rgbOfOklab([light, c * Math.cos(angle), c * Math.sin(angle)]);
  let rgb = at(chroma);
  if (!shown(rgb)) {
    let low = 0;
    let high = chroma;
    for (let i = 0; i < 16; ++i) {
      const middle = (low + high) / 2;
      if (shown(at(middle))) low = middle;
      else high = middle;
    }
    rgb = at(low);
  }
  const inside = (v: number) => Math.min(1, Math.max(0, v));
  return [inside(rgb[0]), inside(rgb[1]), inside(rgb[2])];
}

/// `share` 0 is `a`, 1 is `b`; between them the way is straight in OKLab.
export function mix(a: Rgb, b: Rgb, share: number): Rgb {
  const from = oklabOfRgb(a);
  const to = oklabOfRgb(b);
  const at = (i: 0 | 1 | 2) => from[i] + (to[i] - from[i]) * share;
  const inside = (v: number) => Math.min(1, Math.max(0, v));
  const rgb = rgbOfOklab([at(0), at(1), at(2)]);
  return [inside(rgb[0]), inside(rgb[1]), inside(rgb[2])];
}
