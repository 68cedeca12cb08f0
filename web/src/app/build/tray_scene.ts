/// Between a build and its 3D view: hands on what changed since the last time, no more.

import type { CopyKey, Size, Transform, TrayView, ViewCopy, ViewPart } from "../../view/view";
import type { MoveState } from "../change/mover";
import { type BuildView, isHidden } from "../state/build_view";
import type { Sides } from "../state/draft";
import { copyId, type LiveRun } from "../state/live_run";
import type { Loaded } from "../state/mesh_store";
import type { PackedTray, Packing, Placement } from "../state/packing";
import type { Session } from "../state/session";
import { traySize } from "../state/tray_size";
import type { BuildPart } from "./build_parts";

/// A mesh has about so many at most where it is fine. So many in all are drawn fluently by any machine, and by none.
const fineTriangles = 10_000;
const leastTriangles = 100_000;
const mostTriangles = 3_000_000;
/// A mesh has so many at most where it is coarse. Above so many in all, rough ones come first, and coarse ones only where
/// the machine draws them fast.
const coarseTriangles = 800;
const roughFrom = 500_000;

export class TrayScene {
  private parts = "";
  private standing = "";
  private hidden: readonly unknown[] = [];
  private ready = false;
  private asked = "";
  private labelled = "";
  private readonly refined = new Set<number>();
  /// Rough meshes stand for coarse ones of so many triangles; 0: they are coarse already.
  private coarseLater = 0;
  private refining = false;
  private shown: PackedTray | null = null;
  private shownParts: readonly BuildPart[] = [];
  private moving: CopyKey | null = null;
  private handled: CopyKey | null = null;
  private movedTo: Transform | null = null;

  constructor(
    private readonly session: Session,
    private readonly view: TrayView,
    private readonly changed: () => void,
  ) {}

  /// Changes whenever all copies are placed anew; empty while there are none.
  get placed(): string {
    return this.ready ? this.standing : "";
  }

  /// The tray while it packs: from the draft. `lands`: the newest copy is seen to land.
  showLive(parts: readonly BuildPart[], live: LiveRun, tray: number, lands = true): void {
    const { draft, info } = this.session;
    const meshes = this.session.parts.meshes;
    const size = traySize(draft, info, meshes) ?? [100, 100, 100];
    const boxes = draft.keepOut.flatMap((own) => ("box" in own ? [own.box] : []));
    const container = draft.tray.kind === "mesh" ? draft.tray.file : null;
    this.setTray(size, draft.openHeight, boxes, container);
    if (!this.setParts(parts, (part) => part.count)) return;
    const key = `live ${tray}`;
    const whole = key !== this.standing;
    const first = this.standing === "";
    if (whole) this.view.clear();
    this.standing = key;
    const { cleared, placed, removed } = live.drain(tray, whole);
    if (cleared && !whole) this.view.clear();
    if (removed.length > 0) this.view.remove(removed);
    const newest = lands && live.newest?.tray === tray ? live.newest.copy : null;
    const landing = placed.filter((copy) => copy.part === newest?.part && copy.copy === newest.copy);
    const others = placed.filter((copy) => !landing.includes(copy));
    if (others.length > 0) this.view.place(others);
    if (landing.length > 0) this.view.place(landing, true);
    if (first) this.view.frame(null);
  }

  /// A tray of the finished build. `changes`: of the one that is shown already, only what is another is placed anew.
  showPacked(parts: readonly BuildPart[], packing: Packing, tray: PackedTray, changes = false): void {
    const container = this.session.draft.tray.kind === "mesh" ? this.session.draft.tray.file : null;
    this.setTray(packing.size, packing.openHeight, packing.keepOut, container);
    if (!this.setParts(parts, copiesIn(tray))) return;
    const key = `packed ${tray.number} ${numberOf(tray)}`;
    if (key === this.standing) return;
    const first = this.standing === "";
    const before = this.standing.startsWith(`packed ${tray.number} `) ? this.shown : null;
    this.standing = key;
    this.shown = tray;
    this.shownParts = parts;
    if (changes && before) this.placeChanged(before, tray);
    else {
      this.view.clear();
      this.view.place(tray.placements.map(viewCopy));
    }
    if (first) this.view.frame(null);
    void this.refine(parts, tray);
  }

  private placeChanged(before: PackedTray, tray: PackedTray): void {
    const gone = [...before.byId].filter(([id]) => !tray.byId.has(id)).map(([, placement]) => placement);
    if (gone.length > 0) this.view.remove(gone);
    const others = tray.placements.filter((placement) => !alike(before.byId.get(copyId(placement)), placement));
    if (others.length > 0) this.view.place(others.map(viewCopy));
  }

  /// A copy that is moved by hand, and what it touches; null: none, and all stand where the tray has them.
  showMove(move: MoveState, tray: PackedTray | undefined, close: readonly CopyKey[]): void {
    const { copy, transform } = move;
    if (this.moving && (!copy || copyId(copy) !== copyId(this.moving))) {
      const back = tray?.byId.get(copyId(this.moving));
      if (back) this.view.place([viewCopy(back)]);
      else this.view.remove([this.moving]);
      this.moving = null;
      this.movedTo = null;
    }
    // Said again it would let go of a handle that is held.
    if (copy !== this.handled) this.view.setMoving(copy);
    this.handled = copy;
    this.view.setLeaving(copy ? [copy] : []);
    this.view.setMarked(close, copy !== null, "bad");
    if (!copy || transform === this.movedTo || !this.ready) return;
    this.moving = copy;
    this.movedTo = transform;
    this.view.place([{ part: copy.part, copy: copy.copy, transform, order: tray?.byId.get(copyId(copy))?.index ?? 0 }]);
  }

  /// What is looked at, and how.
  showView(build: BuildView, locked: readonly CopyKey[] = []): void {
    this.view.setLocked(locked);
    this.view.setColouring(build.colouring);
    this.view.setSection(build.section);
    this.view.setSelected(build.selected);
    const hidden = [build.hiddenParts, build.hiddenCopies, build.isolated];
    if (hidden.every((set, i) => set === this.hidden[i])) return;
    this.hidden = hidden;
    this.view.setHidden((copy: CopyKey) => isHidden(build, copy));
  }

  /// The names of the copy that is selected and of the one under the pointer.
  showLabels(parts: readonly BuildPart[], selected: readonly CopyKey[], hovered: CopyKey | null): void {
    const named = [...(selected.length === 1 ? selected : []), ...(hovered ? [hovered] : [])];
    const labels = new Map(
      named.map((copy) => {
        const part = parts.find((own) => own.index === copy.part);
        return [copyId(copy), { copy, text: `${part?.name ?? ""} ${copy.copy + 1}` }];
      }),
    );
    const key = [...labels.keys()].join();
    if (key === this.labelled) return;
    this.labelled = key;
    this.view.setLabels([...labels.values()]);
  }

  private setTray(size: Sides, open: boolean, boxes: readonly (readonly [Sides, Sides])[], file: string | null): void {
    const mesh = file === null ? null : this.session.parts.meshes.find((own) => own.file === file);
    const data = mesh ? this.session.meshes.mesh(mesh) : null;
    if (mesh && !data) void this.session.meshes.load([mesh]).then(this.changed);
    const key = JSON.stringify([size, open, boxes, file, data !== null]);
    if (key === this.asked) return;
    this.asked = key;
    const keepOut = boxes.map((box) => [...box] as Size[]);
    this.view.setTray([size[0], size[1], open ? null : size[2]], data ?? undefined, keepOut);
  }

  /// False while meshes are still to come. `copies`: how many of a part are to be drawn.
  private setParts(parts: readonly BuildPart[], copies: (part: BuildPart) => number): boolean {
    const key = parts.map((part) => `${part.index}:${part.mesh?.id}:${part.mesh?.volume}`).join();
    if (key !== this.parts) {
      this.parts = key;
      this.ready = false;
      this.standing = "";
      this.refined.clear();
      const triangles = trianglesOf(parts, copies, coarseTriangles);
      const rough = triangles > roughFrom;
      this.coarseLater = rough ? triangles : 0;
      void this.load(parts, rough ? "rough" : "coarse").then((found) => {
        if (key !== this.parts) return;
        this.view.setParts(found);
        this.ready = true;
        this.changed();
      });
    }
    return this.ready;
  }

  private async load(parts: readonly BuildPart[], detail: Loaded): Promise<ViewPart[]> {
    const { meshes } = this.session;
    await meshes.load(
      parts.flatMap((part) => (part.mesh ? [part.mesh] : [])),
      detail,
    );
    return parts.flatMap((part) => {
      const mesh = part.mesh ? meshes.mesh(part.mesh, detail) : null;
      return mesh ? [{ index: part.index, name: part.name, mesh }] : [];
    });
  }

  /// The view has measured anew how fast it draws.
  paced(): void {
    if (this.shown && this.ready) void this.refine(this.shownParts, this.shown);
  }

  /// Coarse meshes for rough ones once the machine has shown that it draws so many (a slow one only at rest), then fine ones
  /// where they are few.
  private async refine(parts: readonly BuildPart[], tray: PackedTray): Promise<void> {
    if (this.refining) return;
    this.refining = true;
    try {
      await this.coarsen(parts);
      await this.fine(parts, tray);
    } finally {
      this.refining = false;
    }
  }

  private async coarsen(parts: readonly BuildPart[]): Promise<void> {
    const speed = this.coarseLater > 0 ? this.view.draws(this.coarseLater) : "never";
    if (speed === "never") return;
    const key = this.parts;
    const coarse = await this.load(parts, "coarse");
    if (key !== this.parts) return;
    this.coarseLater = 0;
    this.view.refine(new Map(coarse.map(({ index, mesh }) => [index, mesh])), speed === "slowly");
  }

  private async fine(parts: readonly BuildPart[], tray: PackedTray): Promise<void> {
    if (this.coarseLater > 0) return;
    const copies = copiesIn(tray);
    const triangles = trianglesOf(parts, copies, fineTriangles);
    if (triangles > mostTriangles) return;
    if (triangles > leastTriangles && this.view.draws(triangles) !== "fast") return;
    const key = this.parts;
    for (const part of parts) {
      if (!part.mesh || copies(part) === 0 || this.refined.has(part.index)) continue;
      const fine = await this.session.meshes.fine(part.mesh);
      if (key !== this.parts || !this.standing.startsWith(`packed ${tray.number} `)) return;
      if (!fine || this.refined.has(part.index)) continue;
      this.refined.add(part.index);
      this.view.refine(new Map([[part.index, fine]]));
    }
  }
}

/// How many copies of a part stand in a tray; they are counted once that is asked for.
function copiesIn(tray: PackedTray): (part: BuildPart) => number {
  let copies: Map<number, number> | null = null;
  return (asked) => {
    if (!copies) {
      copies = new Map();
      for (const { part } of tray.placements) copies.set(part, (copies.get(part) ?? 0) + 1);
    }
    return copies.get(asked.index) ?? 0;
  };
}

function trianglesOf(parts: readonly BuildPart[], copies: (part: BuildPart) => number, most: number): number {
  return parts.reduce((sum, part) => sum + Math.min(most, part.mesh?.triangles ?? 0) * copies(part), 0);
}

/// Trays are never changed, only replaced: each has a number of its own.
const numbers = new WeakMap<PackedTray, number>();
let trays = 0;

function numberOf(tray: PackedTray): number {
  const known = numbers.get(tray) ?? ++trays;
  numbers.set(tray, known);
  return known;
}

function alike(before: Placement | undefined, now: Placement): boolean {
  if (!before || before.step !== now.step || before.index !== now.index) return false;
  return before.transform.every((row, i) => row.every((value, j) => value === now.transform[i]?.[j]));
}

function viewCopy(placement: PackedTray["placements"][number]): ViewCopy {
  const { part, copy, transform, index, step } = placement;
  return step === null ? { part, copy, transform, order: index } : { part, copy, transform, order: index, step };
}
