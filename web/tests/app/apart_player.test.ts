/// The player's time: playing, stepping, stopping where it should.

import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { matches, nameOf } from "../../src/app/shell/key_names";
import { Player, shownStep, stepTime } from "../../src/app/state/apart_player";
import type { PackedStep, PackedTray, Placement } from "../../src/app/state/packing";

const step = (...placements: number[]): PackedStep => ({ placements, path: [[0, 0, 10]], throughWalls: false });

function tray(...plan: PackedStep[]): PackedTray {
  const placements = Array.from({ length: 6 }, (_, index) => ({ index }) as Placement);
  return { number: 1, plan, placements, steps: plan.length } as unknown as PackedTray;
}

let player: Player;

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout", "performance"] });
  vi.stubGlobal("requestAnimationFrame", (run: (now: number) => void) => setTimeout(() => run(performance.now()), 16));
  vi.stubGlobal("cancelAnimationFrame", clearTimeout);
  player = new Player();
  player.take(tray(step(0), step(1, 2), step(3), step(1), step(2), step(4)));
});
afterEach(() => {
  player.pause();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe("the player", () => {
  it("takes 0.6 s a step, and less at a higher speed", () => {
    player.play();
    vi.advanceTimersByTime(2 * stepTime);
    expect(player.time).toBeCloseTo(2, 0);
    player.setSpeed(16);
    vi.advanceTimersByTime(2 * stepTime);
    expect(player.time).toBe(6);
    expect(player.state.value.playing).toBe(false);
    expect(player.state.value.step).toBe(6);
  });

  it("begins again after the end", () => {
    player.seek(6);
    player.play();
    vi.advanceTimersByTime(100);
    expect(player.time).toBeLessThan(1);
  });

  it("stops where it was told to", () => {
    player.play(2);
    vi.advanceTimersByTime(10 * stepTime);
    expect(player.time).toBe(2);
    expect(player.state.value.playing).toBe(false);
  });

  it("steps to the ends of steps, also from within one, and not past the ends", () => {
    player.seek(2.4);
    player.move(1);
    vi.advanceTimersByTime(400);
    expect(player.time).toBe(3);
    player.seek(2.4);
    player.move(-1);
    vi.advanceTimersByTime(400);
    expect(player.time).toBe(2);
    player.move(10);
    expect(player.time).toBe(6);
    player.move(-10);
    expect(player.time).toBe(0);
  });

  it("counts keys that come fast", () => {
    for (let i = 0; i < 3; i += 1) player.move(1);
    vi.advanceTimersByTime(400);
    expect(player.time).toBe(3);
  });

  it("plays a group by itself and passes over the steps of others", () => {
    player.playAlone(1);
    const seen = new Set<number | undefined>();
    for (let i = 0; i < 400 && player.state.value.playing; i += 1) {
      seen.add(shownStep(player.state.value)?.index);
      vi.advanceTimersByTime(16);
    }
    expect([...seen]).toEqual([1, 3, 4]);
    expect(player.time).toBe(5);
    expect(shownStep(player.state.value)).toBeNull();
    player.seek(3);
    expect(player.state.value.alone).toBe(1);
    player.seek(5);
    expect(player.state.value.alone).toBeNull();
    expect(shownStep(player.state.value)?.index).toBe(5);
  });

  it("goes step by step for who wants no motion", () => {
    vi.stubGlobal("matchMedia", () => ({ matches: true }));
    player.play();
    vi.advanceTimersByTime(stepTime - 10);
    expect(player.time).toBe(0);
    vi.advanceTimersByTime(20);
    expect(player.time).toBe(1);
    vi.advanceTimersByTime(10 * stepTime);
    expect(player.time).toBe(6);
    expect(player.state.value.playing).toBe(false);
  });

  it("begins anew with another tray, and not with the same", () => {
    const other = tray(step(0), step(1));
    player.seek(3);
    player.take(other);
    expect(player.time).toBe(0);
    expect(player.steps).toBe(2);
    player.seek(1);
    player.take(other);
    expect(player.time).toBe(1);
  });
});

describe("its keys", () => {
  const press = (key: string, more: Partial<KeyboardEvent> = {}) =>
    nameOf({ key, code: "", ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...more });

  it("are written by what they look like", () => {
    expect(matches(["←"], press("ArrowLeft"))).toBe(true);
    expect(matches(["←"], press("ArrowLeft", { shiftKey: true }))).toBe(false);
    expect(matches(["Shift+→"], press("ArrowRight", { shiftKey: true }))).toBe(true);
    expect(matches(["Space"], press(" "))).toBe(true);
  });
});
