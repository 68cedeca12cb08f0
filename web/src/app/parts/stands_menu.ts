/// How a part may stand, as a menu in its row.

import { html, type TemplateResult } from "lit";
import { icon } from "../common/icons";
import "../common/menu";
import type { Stands } from "../state/draft";
import { standsChoices, standsIcon, standsOfKind, standsText } from "../words/stands";

export function standsMenu(label: string, stands: Stands, pick: (stands: Stands) => void): TemplateResult {
  return html`<sp-menu
    label=${`${label}: ${standsText(stands)}`}
    buttonClasses="ori"
    .button=${html`${icon(standsIcon(stands))}<span>${standsText(stands)}</span>${icon("down")}`}
    .content=${() =>
      html`${standsChoices.map(
        (choice) =>
          html`<button
            type="button"
            class="mi"
            role="menuitemradio"
            aria-checked=${choice.value === stands.kind}
            @click=${() => pick(standsOfKind(choice.value, stands))}
          >
            ${icon(choice.icon)}<span>${choice.text}</span>${choice.value === stands.kind ? icon("check") : ""}
          </button>`,
      )}`}
  ></sp-menu>`;
}
