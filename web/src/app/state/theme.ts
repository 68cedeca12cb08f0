/// Light, dark, or as the system has it. The sheets follow the root's color-scheme (styles/tokens.css).

import { app, type ThemeChoice } from "./app_state";
import { keep } from "./kept";

const dark = () => matchMedia("(prefers-color-scheme: dark)");

function show(): void {
  const choice = app.value.choice;
  const theme = choice === "system" ? (dark().matches ? "dark" : "light") : choice;
  document.documentElement.dataset.theme = theme;
  app.set({ theme });
}

export function setTheme(choice: ThemeChoice): void {
  keep("theme", choice);
  app.set({ choice });
  show();
}

export function followTheme(): void {
  dark().addEventListener("change", show);
  show();
}
