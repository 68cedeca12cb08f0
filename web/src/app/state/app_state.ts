/// What all of the page shares: where one is, what the server is, the theme, and what is to be said at once.

import type { Info } from "../../api/types";
import type { Theme } from "../../view/view";
import { keep, kept } from "./kept";
import type { Route } from "./route";
import { Store } from "./store";

export type ThemeChoice = "light" | "dark" | "system";

export interface Toast {
  readonly text: string;
  readonly undo: () => void;
}

export interface AppState {
  readonly route: Route;
  readonly info: Info | null;
  readonly tokenWanted: boolean;
  readonly connected: boolean;
  readonly choice: ThemeChoice;
  readonly theme: Theme;
  /// What went wrong and belongs to no other place: one sentence.
  readonly problem: string | null;
  readonly toast: Toast | null;
  /// Said to screen readers.
  readonly announcement: string;
  readonly letterKeys: boolean;
  readonly dialog: "help" | null;
}

export const app = new Store<AppState>({
  route: { page: "start" },
  info: null,
  tokenWanted: false,
  connected: true,
  choice: kept<ThemeChoice>("theme", "system"),
  theme: "light",
  problem: null,
  toast: null,
  announcement: "",
  letterKeys: kept("letterKeys", true),
  dialog: null,
});

export function setLetterKeys(on: boolean): void {
  keep("letterKeys", on);
  app.set({ letterKeys: on });
}

export function announce(text: string): void {
  app.set({ announcement: text });
}

export function tell(problem: string | null): void {
  app.set({ problem });
}

/// Runs what may fail, and says what went wrong in the banner.
export async function attempt<T>(what: () => Promise<T>): Promise<T | null> {
  try {
    const value = await what();
    tell(null);
    return value;
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") return null;
    tell(messageOf(error));
    return null;
  }
}

export function messageOf(error: unknown): string {
  return error instanceof Error && error.message ? error.message : "Something went wrong. Reload the page.";
}
