/// Which rows of a long list are in sight; only those are drawn.

export interface Sight {
  readonly first: number;
  readonly last: number;
  readonly before: number;
  readonly after: number;
}

/// Which rows a window of `height` at `top` shows, with some to spare on both sides.
export function sightOf(heights: readonly number[], top: number, height: number, spare = 400): Sight {
  let y = 0;
  let first = 0;
  while (first < heights.length && y + (heights[first] ?? 0) <= top - spare) y += heights[first++] ?? 0;
  const before = y;
  let last = first;
  while (last < heights.length && y < top + height + spare) y += heights[last++] ?? 0;
  let after = 0;
  for (let i = last; i < heights.length; i += 1) after += heights[i] ?? 0;
  return { first, last, before, after };
}
