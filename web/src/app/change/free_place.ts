/// The nearest free place on the way that a copy came: first by the page's own meshes, which costs nothing, then by the
/// server, which knows the gaps. A place on the way is a share from 0, where it may stand, to 1, where it may not.

export interface Way {
  /// mm
  readonly length: number;
  /// Whether it touches nothing there, as far as the page knows.
  touchesNothing(share: number): boolean;
  /// Whether it may stand there, as the server says.
  mayStand(share: number): Promise<boolean>;
}

/// mm; finer is not worth asking for.
const fine = 0.1;
const samples = 64;
const mostAsked = 14;

/// The share nearest to 1 where it may stand; 0 is taken on trust.
export async function nearestFree(way: Way): Promise<number> {
  const near = fine / Math.max(fine, way.length);
  let tried = localFree(way, near);
  let free = 0;
  let taken = 1;
  for (let asked = 0; asked < mostAsked && taken - free > near; asked += 1) {
    if (await way.mayStand(tried)) free = tried;
    else taken = tried;
    tried = (free + taken) / 2;
  }
  return free;
}

/// The last place before the copies that it ran into.
function localFree(way: Way, near: number): number {
  let taken = 1;
  let free = 1;
  for (let i = samples; i >= 0; i -= 1) {
    free = i / samples;
    if (way.touchesNothing(free)) break;
    taken = free;
  }
  while (taken - free > near) {
    const middle = (free + taken) / 2;
    if (way.touchesNothing(middle)) free = middle;
    else taken = middle;
  }
  return free;
}
