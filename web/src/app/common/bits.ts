/// Small pieces of markup that many screens share.

import { html, nothing, type TemplateResult } from "lit";
import type { Tone } from "../words/jobs";
import { type IconName, icon } from "./icons";
import { styles } from "./styles";

const toneIcons: Readonly<Record<Tone, IconName | null>> = {
  ok: "check",
  warn: "warn",
  bad: "bad",
  run: "clock",
  plain: null,
};

export function badge(tone: Tone, text: string | TemplateResult): TemplateResult {
  const name = toneIcons[tone];
  return html`<span class="badge ${tone}">${name ? icon(name) : nothing}${text}</span>`;
}

export function iconButton(name: IconName, label: string, click: (event: Event) => void, classes = ""): TemplateResult {
  return html`<button type="button" class="btn ghost icon ${classes}" aria-label=${label} title=${label} @click=${click}>
    ${icon(name)}
  </button>`;
}

export interface Choice<T> {
  readonly value: T;
  readonly text: string;
  readonly icon?: IconName;
  readonly disabled?: boolean;
  readonly title?: string;
}

/// One of a few, side by side.
export function segments<T>(
  label: string,
  options: readonly Choice<T>[],
  value: T | null,
  pick: (value: T) => void,
  classes = "fill s",
): TemplateResult {
  return html`<div class="seg ${classes}" role="group" aria-label=${label}>
    ${options.map(
      (option) =>
        html`<button
          type="button"
          aria-pressed=${option.value === value}
          ?disabled=${option.disabled ?? false}
          title=${option.title ?? nothing}
          @click=${() => pick(option.value)}
        >
          ${option.icon ? icon(option.icon) : nothing}<span>${option.text}</span>
        </button>`,
    )}
  </div>`;
}

export function toggle(label: string, on: boolean, change: (on: boolean) => void, disabled = false): TemplateResult {
  return html`<button
    type="button"
    class="switch ${on ? "on" : ""}"
    role="switch"
    aria-checked=${on}
    aria-label=${label}
    ?disabled=${disabled}
    @click=${() => change(!on)}
  ></button>`;
}

export function checkBox(
  label: string,
  state: boolean | "mixed",
  change: (on: boolean, event: MouseEvent) => void,
  tabindex: number | null = null,
): TemplateResult {
  return html`<button
    type="button"
    class="check ${state ? "on" : ""}"
    role="checkbox"
    aria-checked=${state === "mixed" ? "mixed" : state}
    aria-label=${label}
    tabindex=${tabindex ?? nothing}
    @click=${(event: MouseEvent) => change(state !== true, event)}
  >
    ${state === "mixed" ? icon("minus") : state ? icon("check") : nothing}
  </button>`;
}

/// A list to choose from that opens: the browser's own, in our clothes.
export function select<T extends string>(
  label: string,
  options: readonly { readonly value: T; readonly text: string }[],
  value: T | null,
  pick: (value: T) => void,
  classes = "",
  disabled = false,
): TemplateResult {
  return html`<span class="pick ${classes}">
    <select
      aria-label=${label}
      ?disabled=${disabled}
      @change=${(event: Event) => pick((event.target as HTMLSelectElement).value as T)}
    >
      ${value === null ? html`<option value="" selected disabled>–</option>` : nothing}
      ${options.map(
        (option) => html`<option value=${option.value} .selected=${option.value === value}>${option.text}</option>`,
      )}
    </select>
    ${icon("down")}
  </span>`;
}

export function bar(share: number, label: string | null = null, classes = ""): TemplateResult {
  const width = `${Math.max(0, Math.min(1, share)) * 100}%`;
  return label === null
    ? html`<div class="bar ${classes}"><i ${styles({ width })}></i></div>`
    : html`<div
        class="bar ${classes}"
        role="progressbar"
        aria-label=${label}
        aria-valuemin="0"
        aria-valuemax="100"
        aria-valuenow=${Math.round(share * 100)}
      >
        <i ${styles({ width })}></i>
      </div>`;
}

/// A figure with what it is below it.
export function figure(value: string, unit: string, text: string): TemplateResult {
  return html`<div><b>${value} ${unit ? html`<small>${unit}</small>` : nothing}</b><span>${text}</span></div>`;
}

export function picture(address: string | null, classes = "th"): TemplateResult {
  return address
    ? html`<img class=${classes} src=${address} alt="" draggable="false" />`
    : html`<span class="${classes} blank"></span>`;
}
