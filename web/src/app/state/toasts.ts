/// A toast says what was just done, and takes it back for five seconds. What cannot be taken back on the server is only
/// done once they are over, or as soon as something else is done.

import { app } from "./app_state";

const lasts = 5000;

interface Pending {
  readonly finish: () => void;
  timer: number;
}

let pending: Pending | null = null;

/// `undo` takes it back; `then` happens once it can no longer be taken back.
export function toast(text: string, undo: () => void, then: () => void = () => {}): void {
  settle();
  const own: Pending = {
    finish: then,
    timer: 0,
  };
  pending = own;
  app.set({
    toast: {
      text,
      undo: () => {
        if (pending !== own) return;
        clear();
        undo();
      },
    },
  });
  hold(false);
}

/// Time stands still while somebody points at the toast.
export function hold(on: boolean): void {
  if (!pending) return;
  clearTimeout(pending.timer);
  if (!on) pending.timer = window.setTimeout(settle, lasts);
}

/// Does at once what was waiting.
export function settle(): void {
  const finish = pending?.finish;
  clear();
  finish?.();
}

function clear(): void {
  if (pending) clearTimeout(pending.timer);
  pending = null;
  app.set({ toast: null });
}

/// Leaving the page does not leave things half done.
addEventListener("pagehide", settle);
