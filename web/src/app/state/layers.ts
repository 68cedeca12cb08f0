/// The filled share of each layer of a tray, from the floor up.

import type { Extent } from "./turns";

export interface Layers {
  /// mm
  readonly thickness: number;
  /// Of the tray's base, 0 to 1.
  readonly share: readonly number[];
  readonly exact: boolean;
}

export interface Body {
  readonly extent: Extent;
  /// mm³
  readonly volume: number;
}

/// While copies land: each copy's material spread evenly over its height. The packing file has the true areas.
export function approximateLayers(bodies: Iterable<Body>, base: number, height: number, most = 190): Layers {
  const count = Math.max(1, Math.min(most, Math.round(height / 2)));
  const thickness = height / count;
  const share = new Array<number>(count).fill(0);
  for (const { extent, volume } of bodies) {
    const low = extent.low[2];
    const high = Math.max(extent.high[2], low + 1e-6);
    const area = volume / (high - low) / base;
    const first = Math.max(0, Math.floor(low / thickness));
    const last = Math.min(count - 1, Math.floor(high / thickness));
    for (let layer = first; layer <= last; layer += 1) {
      const covered = Math.min(high, (layer + 1) * thickness) - Math.max(low, layer * thickness);
      if (covered > 0) share[layer] = (share[layer] ?? 0) + (area * covered) / thickness;
    }
  }
  return { thickness, share: share.map((value) => Math.min(1, value)), exact: false };
}

export function layerAt(layers: Layers, z: number): number {
  const layer = Math.floor(z / layers.thickness);
  return layers.share[Math.max(0, Math.min(layers.share.length - 1, layer))] ?? 0;
}

/// The fullest layer: its share, and the height of its middle.
export function fullest(layers: Layers): { readonly share: number; readonly z: number } {
  let best = 0;
  layers.share.forEach((share, layer) => {
    if (share > (layers.share[best] ?? 0)) best = layer;
  });
  return { share: layers.share[best] ?? 0, z: (best + 0.5) * layers.thickness };
}

/// The upper end of the plot: a round share a little above the fullest layer's.
export function plotEnd(layers: Layers | null): number {
  if (!layers) return 0.4;
  const most = fullest(layers).share;
  const ends = [0.02, 0.04, 0.06, 0.1, 0.16, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1];
  return ends.find((end) => end >= most * 1.02) ?? 1;
}
