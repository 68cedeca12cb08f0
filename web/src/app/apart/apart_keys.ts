/// The keys of "Take apart".

import { openTray } from "../build/tray_tabs";
import type { Key } from "../shell/keys";
import type { Player } from "../state/apart_player";
import type { Session } from "../state/session";

export interface KeyTargets {
  readonly session: () => Session;
  readonly player: () => Player;
  readonly frame: (all: boolean) => void;
  readonly openExport: () => void;
}

/// Many steps at once.
const many = 10;

/// A focused button, link or switch has the space for itself.
function spaceIsFree(event: KeyboardEvent): boolean {
  return !(event.target as HTMLElement | null)?.closest?.("button, a, summary, [role=switch], [role=menuitem]");
}

export function apartKeys({ session, player, frame, openExport }: KeyTargets): Key[] {
  const move = (key: string, by: number, does: string): Key => ({ keys: [key], does, run: () => player().move(by) });
  return [
    { keys: ["Space"], does: "play, pause", when: spaceIsFree, run: () => player().toggle() },
    move("←", -1, "step back"),
    move("→", 1, "step on"),
    move("Shift+←", -many, "ten steps back"),
    move("Shift+→", many, "ten steps on"),
    { keys: ["Home"], does: "first step", run: () => player().seek(0) },
    { keys: ["End"], does: "after the last step", run: () => player().seek(player().steps) },
    { keys: ["F"], does: "frame what leaves, or what is selected", run: () => frame(false) },
    { keys: ["Shift+F"], does: "frame all", run: () => frame(true) },
    {
      keys: ["/"],
      does: "find a copy or part",
      run: () => session().build.set({ find: session().build.value.find ?? "" }),
    },
    {
      keys: ["Esc"],
      does: "close, let go",
      run: () => {
        const { build } = session();
        if (build.value.find !== null) build.set({ find: null });
        else if (player().state.value.alone !== null) player().playAlone(null);
        else build.set({ selected: [] });
      },
    },
    {
      keys: ["1–9"],
      does: "that tray",
      run: (event) => {
        const tray = Number(event.key);
        if ((session().run.state.value.packing?.trays.length ?? 0) >= tray) openTray(session(), tray);
      },
    },
    { keys: ["Ctrl+E"], does: "export", run: openExport },
  ];
}
