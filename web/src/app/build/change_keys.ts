/// The keys that change a build: lock, remove, undo; and those that hold while a copy is moved.

import type { TrayCopy } from "../change/change";
import type { Key } from "../shell/keys";
import type { Sides } from "../state/draft";
import type { Session } from "../state/session";

/// What is selected in the tray that is shown.
export function selectedCopies(session: Session): TrayCopy[] {
  const { tray, selected } = session.build.value;
  const several = (session.run.state.value.packing?.trays.length ?? 1) > 1;
  if (several && tray === 0) return [];
  return selected.map(({ part, copy }) => ({ tray: several ? tray : 1, part, copy }));
}

/// A button that has the focus takes Enter for itself.
const onButton = (event: KeyboardEvent): boolean =>
  event.target instanceof Element && event.target.closest("button, a, [role=menuitem]") !== null;

export function changeKeys(session: () => Session): Key[] {
  const work = () => session().work;
  const still = () => !work().move.active;
  return [
    {
      keys: ["L"],
      does: "lock what is selected; again: unlock",
      when: still,
      run: () => work().toggleLock(selectedCopies(session())),
    },
    {
      keys: ["Del"],
      does: "remove what is selected",
      when: still,
      run: () => work().remove(selectedCopies(session())),
    },
    { keys: ["M"], does: "move the selected copy", when: still, run: () => beginMove(session()) },
    { keys: ["Ctrl+Z"], does: "undo", run: () => void work().undo() },
    { keys: ["Ctrl+Shift+Z", "Ctrl+Y"], does: "redo", run: () => void work().redo() },
  ];
}

export function beginMove(session: Session): void {
  const [copy, ...others] = selectedCopies(session);
  if (copy && others.length === 0 && !session.work.isLocked(copy)) session.work.move.begin(copy);
}

const steps: readonly (readonly [string, Sides])[] = [
  ["←", [-1, 0, 0]],
  ["→", [1, 0, 0]],
  ["↓", [0, -1, 0]],
  ["↑", [0, 1, 0]],
  ["PageDown", [0, 0, -1]],
  ["PageUp", [0, 0, 1]],
];

/// In front of all others while a copy is moved.
export function moveKeys(session: () => Session): Key[] {
  const move = () => session().work.move;
  const nudges = [1, 10].map((by): Key => {
    const names = steps.map(([name]) => (by === 10 ? `Shift+${name}` : name));
    return {
      keys: names,
      does: `move it by ${by} mm: left, right, to the front, to the back, down, up`,
      run: (event) => {
        const name = { ArrowLeft: "←", ArrowRight: "→", ArrowDown: "↓", ArrowUp: "↑" }[event.key] ?? event.key;
        const step = steps.find(([own]) => own === name)?.[1];
        if (step) move().shift([step[0] * by, step[1] * by, step[2] * by]);
      },
    };
  });
  return [
    ...nudges,
    { keys: ["Enter"], does: "place it here", when: (event) => !onButton(event), run: () => move().place() },
    { keys: ["Esc", "M"], does: "put it back", run: () => move().end() },
  ];
}
