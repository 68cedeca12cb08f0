/// Between the player and the 3D view: hands on which copies moved, left or came back since the last frame, no more.

import type { CopyKey, Size, TrayView, ViewCopy } from "../../view/view";
import { drawnApart, moved, union } from "../state/apart_explode";
import type { PlanStep } from "../state/apart_plan";
import { type PlayerState, shownStep } from "../state/apart_player";
import type { Place } from "../state/apart_time";
import { pathPoints, placeAt } from "../state/apart_time";
import type { Sides } from "../state/draft";
import { copyId } from "../state/live_run";
import type { Placement } from "../state/packing";
import type { Apart } from "./apart";

/// Of the tray's height: so much room is over it in the picture.
const headroom = 0.35;

export interface Look {
  readonly time: number;
  readonly player: PlayerState;
  readonly selected: Placement | null;
  readonly hovered: CopyKey | null;
  /// Copies in the selected one's way.
  readonly blockers: readonly number[];
  readonly hidden: (copy: CopyKey) => boolean;
}

export class ApartScene {
  private apart: Apart | null = null;
  private placed = "";
  /// By placement, where the view has it; null: it has not.
  private shown: (Sides | null)[] = [];
  private exploded: readonly Sides[] = [];
  private told = new Map<string, unknown>();

  constructor(private readonly view: TrayView) {}

  /// `placed` changes when the view has all copies anew, each at its place in the packing.
  show(apart: Apart, placed: string, look: Look): void {
    if (apart !== this.apart || placed !== this.placed) {
      this.apart = apart;
      this.placed = placed;
      this.shown = apart.tray.placements.map(() => [0, 0, 0] as const);
      this.exploded = drawnApart(apart.plan, apart.extents, apart.packing.size);
      this.told.clear();
    }
    this.move(apart, look);
    this.paint(apart, look);
  }

  private move(apart: Apart, look: Look): void {
    const came: ViewCopy[] = [];
    const left: CopyKey[] = [];
    apart.tray.placements.forEach((placement, index) => {
      const to = this.target(apart, index, look);
      const at = this.shown[index] ?? null;
      if (to === null ? at === null : at !== null && to[0] === at[0] && to[1] === at[1] && to[2] === at[2]) return;
      this.shown[index] = to;
      if (to) came.push(viewCopy(placement, to));
      else left.push({ part: placement.part, copy: placement.copy });
    });
    if (left.length > 0) this.view.remove(left);
    if (came.length > 0) this.view.place(came);
  }

  /// How far a copy is drawn from its place; null: not at all.
  private target(apart: Apart, index: number, { time, player }: Look): Sides | null {
    if (player.show === "apart") return this.exploded[index] ?? [0, 0, 0];
    const place: Place = placeAt(apart.plan, index, time);
    if (place.kind !== "out") return place.offset;
    return player.faint ? [0, 0, 0] : null;
  }

  private paint(apart: Apart, look: Look): void {
    const { player, selected, hovered, blockers, time } = look;
    const { view } = this;
    const { tray } = apart;
    const step = shownStep(player);
    const all = player.show === "apart";
    const keys = (indices: readonly number[]) => indices.flatMap((index) => tray.placements[index] ?? []).map(keyOf);
    const leaving = step?.placements ?? [];
    const now = Math.floor(time);
    const tell = (what: string, value: unknown, run: () => void) => {
      const key = JSON.stringify(value);
      if (this.told.get(what) === key) return;
      this.told.set(what, key);
      run();
    };
    tell("leaving", leaving, () => view.setLeaving(keys(leaving), true));
    tell("selected", selected?.index, () => view.setSelected(selected ? [keyOf(selected)] : []));
    tell("marked", [blockers, all], () => view.setMarked(keys(blockers), !all));
    const gone = player.faint || all;
    tell("faint", gone ? now : -1, () => {
      const out = (copy: CopyKey) => isOut(apart, copy, now);
      view.setFaint(gone ? out : null);
    });
    this.setHidden(apart, look);
    tell("labels", [step?.index, selected?.index, hovered], () =>
      view.setLabels(this.labels(apart, step, selected, hovered)),
    );
    tell("path", [all, step?.index], () => view.setPath(step && !all ? this.path(apart, step) : null));
    tell("follow", [player.follow && !all, leaving], () =>
      view.setFollowed(player.follow && !all && leaving.length > 0 ? keys(leaving) : null),
    );
    tell("surround", all, () => view.setSurround(all ? this.explodedBox(apart) : above(apart)));
  }

  private setHidden(apart: Apart, { player, hidden }: Look): void {
    const { alone } = player;
    const before = this.told.get("hidden") as readonly unknown[] | undefined;
    if (before?.[0] === alone && before[1] === hidden) return;
    this.told.set("hidden", [alone, hidden]);
    const members = alone === null ? null : new Set(apart.plan.assemblies[alone]?.members);
    this.view.setHidden((copy) => {
      if (!members) return hidden(copy);
      const placement = apart.tray.byId.get(copyId(copy));
      return !placement || !members.has(placement.index);
    });
  }

  private labels(apart: Apart, step: PlanStep | null, selected: Placement | null, hovered: CopyKey | null) {
    const texts = new Map<number, string>();
    const first = step?.placements[0];
    if (step && first !== undefined) {
      texts.set(first, step.makes === null ? apart.nameOf(first) : `Group of ${step.placements.length}`);
    }
    const over = hovered ? apart.tray.byId.get(copyId(hovered)) : undefined;
    for (const own of [selected, over]) if (own && !texts.has(own.index)) texts.set(own.index, apart.nameOf(own.index));
    return [...texts].flatMap(([index, text]) => {
      const placement = apart.tray.placements[index];
      return placement ? [{ copy: keyOf(placement), text, beside: index === first }] : [];
    });
  }

  private path(apart: Apart, step: PlanStep): Size[] | null {
    const box = union(step.placements.flatMap((index) => apart.extents[index] ?? []));
    if (!box || step.path.length === 0) return null;
    const centre: Sides = [
      (box.low[0] + box.high[0]) / 2,
      (box.low[1] + box.high[1]) / 2,
      (box.low[2] + box.high[2]) / 2,
    ];
    return pathPoints(apart.plan, step, centre);
  }

  private explodedBox(apart: Apart): readonly [Size, Size] | null {
    const boxes = apart.extents.flatMap((own, i) => (own ? [moved(own, this.exploded[i] ?? [0, 0, 0])] : []));
    const box = union(boxes);
    return box ? [box.low, box.high] : null;
  }
}

function keyOf({ part, copy }: Placement): CopyKey {
  return { part, copy };
}

function isOut(apart: Apart, copy: CopyKey, now: number): boolean {
  const placement = apart.tray.byId.get(copyId(copy));
  return placement !== undefined && (apart.plan.outAt[placement.index] ?? 0) < now;
}

/// Copies go up and out: there they are still to be seen.
function above({ packing, tray }: Apart): readonly [Size, Size] {
  const [x, y, z] = packing.size;
  const height = packing.openHeight ? tray.height : z;
  return [
    [0, 0, 0],
    [x, y, height * (1 + headroom)],
  ];
}

function viewCopy(placement: Placement, by: Sides): ViewCopy {
  const { part, copy, transform, index } = placement;
  const moves = [...by, 0];
  const moved = transform.map((row, r) => row.map((value, c) => (c === 3 ? value + (moves[r] ?? 0) : value)));
  return { part, copy, transform: moved, order: index };
}
