/// The keys of a build, live or done.

import type { Axis } from "../../view/view";
import type { Key } from "../shell/keys";
import { hideSelected, isolateSelected, nextColouring, showAll } from "../state/build_view";
import type { Session } from "../state/session";
import { changeKeys } from "./change_keys";
import { movedSection, newSection } from "./sections";
import { openTray } from "./tray_tabs";

export interface KeyTargets {
  readonly session: () => Session;
  readonly frame: (all: boolean) => void;
  readonly openExport: () => void;
  readonly openPack: () => void;
}

/// While it packs there is nothing yet to cut, hide or take away.
export function buildKeys({ session, frame, openExport, openPack }: KeyTargets, live: boolean): Key[] {
  const build = () => session().build;
  const still = () => !session().work.move.active;
  const axis = (own: Axis): Key => ({
    keys: [own.toUpperCase()],
    does: `section along ${own.toUpperCase()}; again: off`,
    when: still,
    run: () => {
      const before = build().value.section;
      build().set({ section: before?.axis === own ? null : newSection(session(), own, before) });
    },
  });
  const move = (key: string, layers: number, does: string): Key => ({
    keys: [key],
    does,
    run: () => {
      const { section } = build().value;
      if (section) build().set({ section: movedSection(session(), section, layers) });
    },
  });
  const looking: Key[] = [
    { keys: ["F"], does: "frame what is selected", run: () => frame(false) },
    { keys: ["Shift+F"], does: "frame all", run: () => frame(true) },
    { keys: ["/"], does: "find a copy or part", run: () => build().set({ find: build().value.find ?? "" }) },
    { keys: ["Esc"], does: "close, let go", run: () => build().set({ find: null, selected: [] }) },
  ];
  if (live) return looking;
  return [
    ...looking,
    axis("x"),
    axis("y"),
    axis("z"),
    move("[", -1, "section a layer down"),
    move("]", 1, "section a layer up"),
    move("Shift+[", -10, "section ten layers down"),
    move("Shift+]", 10, "section ten layers up"),
    {
      keys: ["B"],
      does: "other side of the section",
      run: () => {
        const { section } = build().value;
        if (section) build().set({ section: { ...section, flipped: !section.flipped } });
      },
    },
    { keys: ["H"], does: "hide what is selected", run: () => build().set(hideSelected(build().value)) },
    { keys: ["I"], does: "show only what is selected", run: () => build().set(isolateSelected(build().value)) },
    { keys: ["Shift+H"], does: "show all", run: () => build().set(showAll) },
    {
      keys: ["C"],
      does: "next colouring",
      run: () => build().set({ colouring: nextColouring(build().value.colouring) }),
    },
    {
      keys: ["1–9"],
      does: "that tray",
      when: still,
      run: (event) => {
        const tray = Number(event.key);
        if ((session().run.state.value.packing?.trays.length ?? 0) >= tray) openTray(session(), tray);
      },
    },
    {
      keys: ["0"],
      does: "all trays",
      when: still,
      run: () => {
        if ((session().run.state.value.packing?.trays.length ?? 0) > 1) openTray(session(), 0);
      },
    },
    { keys: ["Ctrl+E"], does: "export", run: openExport },
    { keys: ["Ctrl+Enter"], does: "pack again: all, or the rest", run: openPack },
    ...changeKeys(session),
  ];
}
