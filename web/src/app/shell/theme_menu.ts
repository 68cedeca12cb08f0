/// Light, dark, or as the system has it.

import { html } from "lit";
import { type IconName, icon } from "../common/icons";
import "../common/menu";
import { app, type ThemeChoice } from "../state/app_state";
import { setTheme } from "../state/theme";

const choices: readonly { readonly value: ThemeChoice; readonly text: string; readonly icon: IconName }[] = [
  { value: "light", text: "Light", icon: "sun" },
  { value: "dark", text: "Dark", icon: "moon" },
  { value: "system", text: "As the system", icon: "system" },
];

export function themeMenu() {
  return html`<sp-menu
    label="Light or dark"
    hint="Light or dark"
    buttonClasses="btn ghost icon"
    .button=${icon(app.value.theme === "dark" ? "sun" : "moon")}
    .content=${() =>
      html`${choices.map(
        (choice) =>
          html`<button
            type="button"
            class="mi"
            role="menuitemradio"
            aria-checked=${app.value.choice === choice.value}
            @click=${() => setTheme(choice.value)}
          >
            ${icon(choice.icon)}<span>${choice.text}</span>${app.value.choice === choice.value ? icon("check") : ""}
          </button>`,
      )}`}
  ></sp-menu>`;
}
