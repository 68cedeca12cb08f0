/// A copy that is moved by hand: where it is at the moment, what it touches there, and what the server says of it. Nothing
/// of it is stored until it is placed.

import { api } from "../../api/client";
import type { Clearance } from "../../api/types";
import type { Axis, CopyKey, Transform } from "../../view/view";
import { packedParts } from "../build/build_parts";
import { announce } from "../state/app_state";
import type { Sides } from "../state/draft";
import type { Session } from "../state/session";
import { Store } from "../state/store";
import { judged } from "../words/move";
import { Asker } from "./asker";
import { type CopyChange, placementOf, type TrayCopy } from "./change";
import { nearestFree } from "./free_place";
import { outward } from "./outward";
import { between, middleOf, quarterTurn, sameTransform, sameTurn, shifted, way } from "./placing";
import { Surroundings } from "./surroundings";

export interface MoveState {
  /// Null: nothing is moved.
  readonly copy: TrayCopy | null;
  /// Where it stood; null: it had been taken out.
  readonly from: Transform | null;
  readonly transform: Transform;
  /// On the page's own meshes.
  readonly touching: readonly CopyKey[];
  readonly outside: boolean;
  /// Of where it is now; null: not measured yet.
  readonly clearance: Clearance | null;
  /// Why it is not measured.
  readonly wait: string | null;
  /// The nearest free place is looked for.
  readonly seeking: boolean;
  /// It is placed as soon as the server says that it may stand there.
  readonly placing: boolean;
}

const none: Transform = [];
const still: MoveState = {
  copy: null,
  from: null,
  transform: none,
  touching: [],
  outside: false,
  clearance: null,
  wait: null,
  seeking: false,
  placing: false,
};

export class Mover {
  readonly state = new Store<MoveState>(still);
  private readonly asker: Asker;
  private around: Surroundings | null = null;
  private lastClear: Transform | null = null;
  private grabbed: Transform | null = null;
  private looking = 0;

  constructor(
    private readonly session: Session,
    private readonly unsent: () => readonly CopyChange[],
    private readonly placed: (copy: TrayCopy, transform: Transform) => void,
  ) {
    this.asker = new Asker({
      ask: (transform, signal) => this.ask(transform, signal),
      answered: (transform, clearance) => this.answered(transform, clearance),
      waits: (wait) => this.state.set({ wait, placing: false }),
    });
  }

  get active(): boolean {
    return this.state.value.copy !== null;
  }

  /// Stands elsewhere than it did.
  get moved(): boolean {
    const { copy, from, transform } = this.state.value;
    return copy !== null && !sameTransform(from, transform);
  }

  /// `start`: where one that was taken out is held first.
  begin(copy: TrayCopy, start: Transform | null = null): void {
    const { packing } = this.session.run.state.value;
    const from = placementOf(packing, copy)?.transform ?? null;
    const transform = from ?? start;
    if (!packing || !transform) return;
    this.end();
    this.around = new Surroundings(packing, this.session.meshes, packedParts(this.session, packing), copy, () =>
      this.lookSoon(),
    );
    this.lastClear = from;
    this.session.build.set({ selected: [{ part: copy.part, copy: copy.copy }], section: null, find: null });
    this.state.set({ ...still, copy, from, transform });
    this.to(transform);
  }

  /// Nothing is moved any more; the copy is where it was.
  end(): void {
    this.asker.stop();
    cancelAnimationFrame(this.looking);
    this.looking = 0;
    this.around = null;
    this.grabbed = null;
    this.state.set(still);
  }

  to(transform: Transform): void {
    if (!this.active) return;
    this.state.set({ transform, clearance: null, wait: null, placing: false });
    this.lookSoon();
    this.asker.want(transform);
  }

  shift(by: Sides): void {
    if (!this.state.value.seeking) this.to(shifted(this.state.value.transform, by));
  }

  /// mm since a handle was grabbed.
  dragged(by: Sides, ended: boolean): void {
    this.grabbed ??= this.state.value.transform;
    const from = this.grabbed;
    if (ended) this.grabbed = null;
    this.to(shifted(from, by));
  }

  turn(axis: Axis): void {
    const { transform, seeking } = this.state.value;
    const extent = this.around?.extent(transform);
    if (extent && !seeking) this.to(quarterTurn(transform, axis, middleOf(extent)));
  }

  extent(transform: Transform) {
    return this.around?.extent(transform) ?? null;
  }

  /// Placed at once where the server has said that it may stand there, else as soon as it says so.
  place(): void {
    const { copy, transform, clearance, touching, outside, seeking } = this.state.value;
    if (!copy || seeking) return;
    if (!this.moved) this.end();
    else if (clearance?.clear) {
      this.end();
      this.placed(copy, transform);
    } else if (!clearance && touching.length === 0 && !outside) this.state.set({ placing: true });
    else announce(this.sentence());
  }

  /// To the nearest place where it may stand.
  async seek(): Promise<void> {
    const { copy, from, transform, seeking } = this.state.value;
    const { around } = this;
    if (!copy || !around || seeking) return;
    this.state.set({ seeking: true });
    try {
      const found = (await this.along(around, transform)) ?? (await this.outwards(around, transform)) ?? from;
      if (this.state.value.copy !== copy) return;
      this.state.set({ seeking: false });
      if (found) this.to(found);
      else this.state.set({ wait: "No free place was found near it. Move it by hand." });
    } catch {
      if (this.state.value.copy === copy) this.state.set({ seeking: false });
    }
  }

  /// Back along the way from where it last was free.
  private async along(around: Surroundings, to: Transform): Promise<Transform | null> {
    const from = this.lastClear;
    if (!from || !sameTurn(from, to)) return null;
    const at = (share: number) => between(from, to, share);
    const share = await nearestFree({
      length: Math.hypot(...way(from, to)),
      touchesNothing: (own) => around.touching(at(own)).length === 0 && !around.isOutside(at(own)),
      mayStand: (own) => this.mayStand(at(own)),
    });
    return at(share);
  }

  private async outwards(around: Surroundings, from: Transform): Promise<Transform | null> {
    return outward(from, {
      touchesNothing: (at) => around.touching(at).length === 0 && !around.isOutside(at),
      mayStand: (at) => this.mayStand(at),
    });
  }

  private async mayStand(transform: Transform): Promise<boolean> {
    return (await this.asker.now(transform)).clear;
  }

  private ask(transform: Transform, signal: AbortSignal): Promise<Clearance> {
    const copy = this.state.value.copy as TrayCopy;
    return api.askClearance(this.session.id, { ...copy, transform }, this.unsent(), signal);
  }

  private answered(transform: Transform, clearance: Clearance): void {
    if (transform !== this.state.value.transform) return;
    if (clearance.clear) this.lastClear = transform;
    const { placing } = this.state.value;
    this.state.set({ clearance, wait: null, placing: false });
    if (placing) this.place();
    else if (!clearance.clear) announce(this.sentence());
  }

  private sentence(): string {
    const { clearance } = this.state.value;
    if (!clearance) return "It touches another copy.";
    const { bold, text } = judged(clearance, (copy) => this.nameOf(copy));
    return `${bold} ${text}`;
  }

  nameOf({ part, copy }: CopyKey): string {
    return `${this.session.run.state.value.packing?.parts[part]?.name ?? "copy"} ${copy + 1}`;
  }

  /// Once a frame, however fast it is dragged.
  private lookSoon(): void {
    if (this.looking !== 0) return;
    this.looking = requestAnimationFrame(() => {
      this.looking = 0;
      const { around } = this;
      if (!around || !this.active) return;
      const { transform } = this.state.value;
      this.state.set({ touching: around.touching(transform), outside: around.isOutside(transform) });
    });
  }
}
