/// The keys. Each screen says which it has while it is shown; none acts while a field has the focus, except Ctrl+Enter
/// and Escape. Letter keys can be switched off (help).

import { app } from "../state/app_state";
import { isLetter, matches, nameOf } from "./key_names";

export interface Key {
  /// As shown: "Ctrl+Z", "F", "Shift+F", "1–9".
  readonly keys: readonly string[];
  readonly does: string;
  /// Where it holds only sometimes: a focused button has the space for itself.
  readonly when?: (event: KeyboardEvent) => boolean;
  readonly run: (event: KeyboardEvent) => void;
}

const sets = new Set<readonly Key[]>();

/// The keys hold until the returned function is called.
export function holdKeys(keys: readonly Key[]): () => void {
  sets.add(keys);
  return () => sets.delete(keys);
}

/// All that hold now, for the help.
export function currentKeys(): Key[] {
  return [...sets].flat();
}

function isTyping(target: EventTarget | null): boolean {
  const element = target as HTMLElement | null;
  return !!element?.closest?.("input:not([type=checkbox]), textarea, select, [contenteditable]");
}

function handle(event: KeyboardEvent): void {
  if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
  const name = nameOf(event);
  if (isTyping(event.target) && name !== "Ctrl+Enter" && name !== "Esc") return;
  if (isLetter(name) && !app.value.letterKeys) return;
  // What was shown last has the first say.
  const key = [...sets]
    .reverse()
    .flat()
    .find((candidate) => matches(candidate.keys, name) && candidate.when?.(event) !== false);
  if (!key) return;
  event.preventDefault();
  if (name === "Ctrl+Enter") (document.activeElement as HTMLElement | null)?.blur();
  key.run(event);
}

let listening = false;

export function listenToKeys(): void {
  if (listening) return;
  listening = true;
  document.addEventListener("keydown", handle);
  holdKeys([{ keys: ["?"], does: "help and keys", run: () => app.set({ dialog: "help" }) }]);
}
