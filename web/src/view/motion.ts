/// The design's motion: 120 ms for what appears, 200 ms for the camera, nothing at all for those who ask for less.

export const fadeTime = 120;
export const cameraTime = 200;

/// cubic-bezier(.2, 0, 0, 1): its x is .6 s (1-s)² + s³ and its y 3 s² (1-s) + s³ at the curve's parameter s.
export function ease(share: number): number {
  if (share <= 0) return 0;
  if (share >= 1) return 1;
  let low = 0;
  let high = 1;
  for (let i = 0; i < 20; ++i) {
    const s = (low + high) / 2;
    if (0.6 * s * (1 - s) ** 2 + s ** 3 < share) low = s;
    else high = s;
  }
  const s = (low + high) / 2;
  return 3 * s * s * (1 - s) + s ** 3;
}

/// Asks each time: people change their mind while a page is open.
export function reducedMotion(): boolean {
  return globalThis.matchMedia?.("(prefers-reduced-motion: reduce)").matches ?? false;
}
