/// How much of the sky reaches the room between the copies: a coarse grid over the tray, so that what lies deep inside is
/// dark and what lies outside is bright. It depends on the copies alone, not on the camera, and costs the drawing one
/// look-up.
///
/// 1. Points spread over the copies' surfaces say how much surface lies in each cell.
/// 2. Light goes through the grid in 26 directions, and a cell with surface lets less of it pass.
/// 3. Each cell keeps the mean light and the direction it comes from: the first four terms of spherical harmonics. A
///    surface there with the normal n gets mean + 2 (direction · n) of an open sky's light (Ramamoorthi and Hanrahan
///    2001).

import { type Box, emptyBox } from "./affine";

export interface Ambient {
  readonly size: readonly [number, number, number];
  /// mm
  readonly cell: number;
  /// The grid's lower corner.
  readonly corner: readonly [number, number, number];
  /// RGBA a cell, x fastest: direction + 0.5, mean.
  readonly texels: Uint8Array<ArrayBuffer>;
}

/// A copy's surface: points in the mesh's coordinates, the transform's rows, and mm² that each point stands for.
export interface Surface {
  readonly points: Float32Array;
  readonly rows: ArrayLike<number>;
  readonly at: number;
  readonly areaEach: number;
}

const longest = 48;
/// Cells all round, so that light comes in from every side.
const border = 2;
/// Through a wall that fills a cell's side, e^-2 = 14 % of the light passes. Walls seldom stand square to it.
const density = 2;

export function ambientGrid(box: Readonly<Box>): Pick<Ambient, "size" | "cell" | "corner"> {
  const side = (axis: number) => Math.max(1e-3, (box[axis + 3] as number) - (box[axis] as number));
  const cell = Math.max(side(0), side(1), side(2)) / longest;
  const cells = (axis: number) => Math.ceil(side(axis) / cell - 1e-6) + 2 * border;
  return {
    size: [cells(0), cells(1), cells(2)],
    cell,
    corner: [box[0] - border * cell, box[1] - border * cell, box[2] - border * cell],
  };
}

/// `keeps`: points that count; those that a section cut away do not.
export function computeAmbient(
  box: Readonly<Box>,
  surfaces: Iterable<Surface>,
  keeps: ((x: number, y: number, z: number) => boolean) | null,
): Ambient {
  const grid = ambientGrid(box);
  const [nx, ny, nz] = grid.size;
  const depths = new Float32Array(nx * ny * nz);
  spread(grid, surfaces, keeps, depths);
  // Points fall into cells by chance; softened, flat walls are evenly bright.
  for (const step of [1, nx, nx * ny]) soften(depths, step);
  // What passes along an axis, and along the diagonals of a side and of the cell: their ways are longer.
  const passes = [1, Math.SQRT2, Math.sqrt(3)].map((way) => depths.map((depth) => Math.exp(depth * way)));
  return { ...grid, texels: shine(nx, ny, nz, passes) };
}

/// An open sky everywhere.
export function openAmbient(): Ambient {
  const box = emptyBox().fill(0) as Box;
  return { ...ambientGrid(box), size: [1, 1, 1], texels: new Uint8Array([128, 128, 128, 255]) };
}

/// Step 1: minus the optical depth of each cell.
function spread(
  { size, cell, corner }: Pick<Ambient, "size" | "cell" | "corner">,
  surfaces: Iterable<Surface>,
  keeps: ((x: number, y: number, z: number) => boolean) | null,
  depths: Float32Array,
): void {
  const [nx, ny, nz] = size;
  for (const { points, rows, at, areaEach } of surfaces) {
    const m = Array.from({ length: 12 }, (_, i) => rows[at + i] as number) as [number, ...number[]];
    const n = (i: number) => m[i] as number;
    const each = (density * areaEach) / (cell * cell);
    for (let i = 0; i + 2 < points.length; i += 3) {
      const px = points[i] as number;
      const py = points[i + 1] as number;
      const pz = points[i + 2] as number;
      const x = n(0) * px + n(1) * py + n(2) * pz + n(3);
      const y = n(4) * px + n(5) * py + n(6) * pz + n(7);
      const z = n(8) * px + n(9) * py + n(10) * pz + n(11);
      if (keeps && !keeps(x, y, z)) continue;
      const cx = Math.floor((x - corner[0]) / cell);
      const cy = Math.floor((y - corner[1]) / cell);
      const cz = Math.floor((z - corner[2]) / cell);
      if (cx < 0 || cy < 0 || cz < 0 || cx >= nx || cy >= ny || cz >= nz) continue;
      const index = cx + nx * (cy + ny * cz);
      depths[index] = (depths[index] as number) - each;
    }
  }
}

/// Each value becomes a mean with its neighbours along an axis, weighted 1 2 1. The border cells are empty.
function soften(values: Float32Array, step: number): void {
  const before = values.slice();
  for (let i = step; i + step < values.length; ++i) {
    values[i] = ((before[i - step] as number) + 2 * (before[i] as number) + (before[i + step] as number)) / 4;
  }
}

/// Steps 2 and 3.
function shine(nx: number, ny: number, nz: number, passesByWay: readonly Float32Array[]): Uint8Array<ArrayBuffer> {
  const cells = nx * ny * nz;
  const mean = new Float32Array(cells);
  const fromX = new Float32Array(cells);
  const fromY = new Float32Array(cells);
  const fromZ = new Float32Array(cells);
  const light = new Float32Array(cells);
  let directions = 0;
  for (let dz = -1; dz <= 1; ++dz) {
    for (let dy = -1; dy <= 1; ++dy) {
      for (let dx = -1; dx <= 1; ++dx) {
        if (dx === 0 && dy === 0 && dz === 0) continue;
        directions += 1;
        // Light comes from (dx, dy, dz): each cell takes it from its neighbour there, so those come first.
        const length = Math.hypot(dx, dy, dz);
        const step = dx + nx * (dy + ny * dz);
        const passes = passesByWay[Math.abs(dx) + Math.abs(dy) + Math.abs(dz) - 1] as Float32Array;
        for (let k = 0; k < nz; ++k) {
          const z = dz > 0 ? nz - 1 - k : k;
          const edgeZ = z + dz < 0 || z + dz >= nz;
          for (let j = 0; j < ny; ++j) {
            const y = dy > 0 ? ny - 1 - j : j;
            const edgeY = edgeZ || y + dy < 0 || y + dy >= ny;
            for (let i = 0; i < nx; ++i) {
              const x = dx > 0 ? nx - 1 - i : i;
              const index = x + nx * (y + ny * z);
              const before = index + step;
              const got =
                edgeY || x + dx < 0 || x + dx >= nx ? 1 : (light[before] as number) * (passes[before] as number);
              light[index] = got;
              mean[index] = (mean[index] as number) + got;
              const share = got / length;
              fromX[index] = (fromX[index] as number) + dx * share;
              fromY[index] = (fromY[index] as number) + dy * share;
              fromZ[index] = (fromZ[index] as number) + dz * share;
            }
          }
        }
      }
    }
  }
  const texels = new Uint8Array(4 * cells);
  const byte = (v: number) => Math.min(255, Math.max(0, Math.round(255 * v)));
  for (let i = 0; i < cells; ++i) {
    texels[4 * i] = byte((fromX[i] as number) / directions + 0.5);
    texels[4 * i + 1] = byte((fromY[i] as number) / directions + 0.5);
    texels[4 * i + 2] = byte((fromZ[i] as number) / directions + 0.5);
    texels[4 * i + 3] = byte((mean[i] as number) / directions);
  }
  return texels;
}
