/// Plays how a tray comes apart. What changes with every frame is in `clock`, all else in `state`, so that lists are not
/// drawn sixty times a second.

import { reducedMotion } from "../../view/motion";
import { type Plan, type PlanStep, partingSteps, planOf } from "./apart_plan";
import { keep, kept } from "./kept";
import type { PackedTray } from "./packing";
import { Store } from "./store";

/// ms a step at 1x, however far it moves.
export const stepTime = 600;
/// ms that a step takes which is asked for by key or button.
const glideTime = 240;
/// ms; a page that was away does not play on as if it had been there.
const longestFrame = 1000;

export const speeds = [0.25, 0.5, 1, 2, 4, 8, 16] as const;

export interface PlayerState {
  readonly plan: Plan | null;
  /// The step that runs, from 0 on; their number once all are done.
  readonly step: number;
  readonly playing: boolean;
  readonly speed: number;
  /// What is left, or all copies drawn apart.
  readonly show: "left" | "apart";
  readonly follow: boolean;
  readonly faint: boolean;
  /// Only this assembly is shown and played.
  readonly alone: number | null;
}

/// The step that is shown to run: while a group is played by itself, none of another.
export function shownStep({ plan, step, alone }: PlayerState): PlanStep | null {
  const own = plan?.steps[step];
  const members = alone === null ? null : plan?.assemblies[alone]?.members;
  return own && (!members || own.placements.some((one) => members.includes(one))) ? own : null;
}

export class Player {
  readonly clock = new Store<{ time: number }>({ time: 0 });
  readonly state = new Store<PlayerState>({
    plan: null,
    step: 0,
    playing: false,
    speed: kept("apart.speed", 1),
    show: "left",
    follow: kept("apart.follow", false),
    faint: kept("apart.faint", false),
    alone: null,
  });
  private tray: PackedTray | null = null;
  /// It stops here.
  private until = Number.POSITIVE_INFINITY;
  private glide: { readonly from: number; readonly to: number; readonly start: number } | null = null;
  private request = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private before = 0;

  /// The tray to take apart; another one begins at its first step.
  take(tray: PackedTray | null): void {
    if (tray === this.tray) return;
    this.tray = tray;
    this.pause();
    this.clock.set({ time: 0 });
    this.state.set({ plan: tray ? planOf(tray) : null, step: 0, alone: null });
  }

  get steps(): number {
    return this.state.value.plan?.steps.length ?? 0;
  }

  get time(): number {
    return this.clock.value.time;
  }

  toggle(): void {
    if (this.state.value.playing) this.pause();
    else this.play();
  }

  /// From here; after the last step from the first.
  play(until = Number.POSITIVE_INFINITY): void {
    if (this.steps === 0) return;
    this.glide = null;
    if (this.state.value.alone !== null) {
      const own = this.stepsAlone();
      if (this.time >= (own[own.length - 1] ?? 0) + 1) this.show(own[0] ?? 0);
    } else if (this.time >= this.steps) this.show(0);
    this.until = until;
    this.state.set({ playing: true });
    this.run();
  }

  pause(): void {
    this.until = Number.POSITIVE_INFINITY;
    this.glide = null;
    cancelAnimationFrame(this.request);
    clearTimeout(this.timer);
    this.request = 0;
    this.state.set({ playing: false });
  }

  /// To a time, at once.
  seek(time: number): void {
    this.pause();
    // Who goes elsewhere has done with the group that was shown by itself.
    if (!this.stepsAlone().includes(Math.floor(time))) this.state.set({ alone: null });
    this.show(time);
  }

  /// So many steps back or on. One is seen to happen; more are there at once.
  move(by: number): void {
    const from = this.glide?.to ?? this.time;
    const whole = by < 0 ? Math.ceil(from - 1e-6) : Math.floor(from + 1e-6);
    const to = Math.max(0, Math.min(this.steps, whole + by));
    this.pause();
    if (Math.abs(by) > 1 || reducedMotion() || this.state.value.show === "apart") {
      this.seek(to);
      return;
    }
    this.glide = { from: this.time, to, start: performance.now() };
    this.run();
  }

  setShow(show: PlayerState["show"]): void {
    this.state.set({ show, ...(show === "apart" ? { alone: null } : {}) });
  }

  setSpeed(speed: number): void {
    keep("apart.speed", speed);
    this.state.set({ speed });
  }

  setFollow(follow: boolean): void {
    keep("apart.follow", follow);
    this.state.set({ follow });
  }

  setFaint(faint: boolean): void {
    keep("apart.faint", faint);
    this.state.set({ faint });
  }

  /// Plays an assembly by itself: how it leaves, and how it is parted. Null: all again.
  playAlone(assembly: number | null): void {
    this.pause();
    this.state.set({ alone: assembly, show: "left" });
    const own = this.stepsAlone();
    if (assembly === null || own.length === 0) return;
    this.show(own[0] ?? 0);
    this.play();
  }

  private stepsAlone(): number[] {
    const { plan, alone } = this.state.value;
    const own = alone === null ? undefined : plan?.assemblies[alone];
    if (!plan || !own) return [];
    return [own.madeBy, ...partingSteps(plan, own.number).map((step) => step.index)];
  }

  private show(time: number): void {
    const held = Math.max(0, Math.min(this.steps, time));
    this.clock.set({ time: held });
    this.state.set({ step: Math.floor(held) });
  }

  private run(): void {
    this.before = performance.now();
    if (reducedMotion() && !this.glide) {
      this.timer = setTimeout(() => this.jump(), stepTime / this.state.value.speed);
      return;
    }
    this.request = requestAnimationFrame((now) => this.frame(now));
  }

  /// For who wants no motion: a step at a time.
  private jump(): void {
    this.advance(Math.floor(this.time) + 1);
    if (this.state.value.playing) this.run();
  }

  private frame(now: number): void {
    if (this.glide) {
      const { from, to, start } = this.glide;
      const share = Math.min(1, Math.max(0, (now - start) / glideTime));
      this.show(from + (to - from) * share);
      if (share === 1) this.pause();
      else this.request = requestAnimationFrame((next) => this.frame(next));
      return;
    }
    const passed = Math.min(longestFrame, Math.max(0, now - this.before));
    this.before = now;
    this.advance(this.time + (passed / stepTime) * this.state.value.speed);
    if (this.state.value.playing) this.request = requestAnimationFrame((next) => this.frame(next));
  }

  private advance(wanted: number): void {
    const end = Math.min(this.until, this.steps);
    let time = wanted;
    if (this.state.value.alone !== null) {
      const own = this.stepsAlone();
      const last = (own[own.length - 1] ?? 0) + 1;
      // Steps of others between them are passed over.
      if (Math.floor(time) !== Math.floor(this.time)) time = own.find((step) => step >= Math.floor(time)) ?? last;
      if (time >= last) {
        this.pause();
        this.show(last);
        return;
      }
    }
    if (time < end) {
      this.show(time);
      return;
    }
    this.pause();
    this.show(end);
  }
}

const players = new WeakMap<object, Player>();

/// The player of an open job: where it was left it is found again.
export function playerOf(session: object): Player {
  let player = players.get(session);
  if (!player) {
    player = new Player();
    players.set(session, player);
  }
  return player;
}
