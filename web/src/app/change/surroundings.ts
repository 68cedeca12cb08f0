/// The copies round one that is moved, on the meshes that the page has: which of them it touches where, and whether it is
/// in the tray. The exact gaps are the server's business.

import type { Mesh } from "../../api/types";
import type { CopyKey, MeshData, Transform } from "../../view/view";
import type { BuildPart } from "../build/build_parts";
import { copyId } from "../state/live_run";
import type { MeshStore } from "../state/mesh_store";
import type { Packing, Placement } from "../state/packing";
import type { Extent } from "../state/turns";
import { clashes } from "../state/views";
import type { TrayCopy } from "./change";
import { boxesMeet, extentIn } from "./placing";

type Touches = Awaited<ReturnType<typeof clashes>>["touches"];

interface Neighbour {
  readonly placement: Placement;
  readonly mesh: Mesh;
  readonly extent: Extent;
}

export class Surroundings {
  private readonly neighbours: readonly Neighbour[];
  private readonly mesh: Mesh | null;
  private readonly fine = new Map<Mesh, MeshData>();
  private readonly asked = new Set<Mesh>();
  private touches: Touches | null = null;

  /// `changed`: better meshes came.
  constructor(
    private readonly packing: Packing,
    private readonly meshes: MeshStore,
    parts: readonly BuildPart[],
    copy: TrayCopy,
    private readonly changed: () => void,
  ) {
    const meshOf = new Map(parts.map((part) => [part.index, part.mesh]));
    this.mesh = meshOf.get(copy.part) ?? null;
    this.neighbours = (packing.trays[copy.tray - 1]?.placements ?? []).flatMap((placement) => {
      const mesh = meshOf.get(placement.part);
      if (!mesh || copyId(placement) === copyId(copy)) return [];
      return [{ placement, mesh, extent: extentIn(placement.transform, mesh, meshes.mesh(mesh)) }];
    });
    void clashes().then((own) => {
      this.touches = own.touches;
      changed();
    });
  }

  /// Null while its mesh is not known.
  extent(transform: Transform): Extent | null {
    return this.mesh && extentIn(transform, this.mesh, this.meshes.mesh(this.mesh));
  }

  /// Of a tray without a ceiling only the sides and the bottom count; a mesh for a tray is the server's business.
  isOutside(transform: Transform): boolean {
    const extent = this.extent(transform);
    if (!extent) return false;
    const over = 1e-6;
    return extent.low.some((low) => low < -over) || extent.high.some((high, i) => high > this.end(i) + over);
  }

  touching(transform: Transform): CopyKey[] {
    const { mesh, touches } = this;
    const extent = this.extent(transform);
    if (!mesh || !extent || !touches) return [];
    const own = this.dataOf(mesh);
    if (!own) return [];
    return this.neighbours
      .filter((neighbour) => boxesMeet(extent, neighbour.extent))
      .filter((neighbour) => {
        const data = this.dataOf(neighbour.mesh);
        return data && touches({ mesh: own, transform }, { mesh: data, transform: neighbour.placement.transform });
      })
      .map(({ placement }) => ({ part: placement.part, copy: placement.copy }));
  }

  private end(axis: number): number {
    return axis === 2 && this.packing.openHeight ? Infinity : (this.packing.size[axis] ?? 0);
  }

  /// The finer one where it is there; it is asked for when it first matters.
  private dataOf(mesh: Mesh): MeshData | null {
    if (!this.asked.has(mesh)) {
      this.asked.add(mesh);
      void this.meshes.fine(mesh).then((data) => {
        if (!data) return;
        this.fine.set(mesh, data);
        this.changed();
      });
    }
    return this.fine.get(mesh) ?? this.meshes.mesh(mesh);
  }
}
