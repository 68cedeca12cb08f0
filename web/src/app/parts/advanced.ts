/// Every other option of the program that may be set here, grouped as in its help. Each has its help text below it.

import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Json, Option } from "../../api/types";
import { select, toggle } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { getOption, setOption } from "../state/draft_edit";
import {
  advancedOptions,
  choices,
  defaultChoice,
  fieldKind,
  onByDefault,
  optionText,
  readOption,
} from "../state/option_values";
import type { Session } from "../state/session";
import { counted } from "../words/numbers";
import { defaultText, groupTitle, helpOf, label } from "../words/options";

/// Stands for the default in a choice.
const usual = "";

@customElement("sp-advanced")
export class Advanced extends Piece {
  @property({ attribute: false }) session!: Session;
  @state() private find = "";
  @state() private readonly problems = new Map<string, string>();

  protected override stores() {
    return [this.session.state, this.session.view];
  }

  override render() {
    const { session } = this;
    const options = advancedOptions(session.info.options).filter((option) => option.name !== "material-density");
    if (options.length === 0) return nothing;
    const { advanced: open } = session.view.value;
    const set = options.filter((option) => this.isSet(option)).length;
    return html`<section class="sec advanced">
      <button
        type="button"
        class="row fold"
        aria-expanded=${open}
        @click=${() => session.view.set({ advanced: !open })}
      >
        ${icon(open ? "down" : "right")}<span class="b grow">Advanced</span>
        <span class="count">${set === 0 ? "all at their defaults" : `${counted(set, "option")} set`}</span>
      </button>
      ${open ? this.all(options, set) : nothing}
    </section>`;
  }

  private isSet(option: Option): boolean {
    const value = getOption(this.session.draft, option.name);
    return value !== undefined && !(option.name === "height-at" && this.session.draft.goal === "lowest");
  }

  private all(options: readonly Option[], set: number): TemplateResult {
    const words = this.find.trim().toLowerCase();
    const shown = options.filter((option) => `${label(option.name)} ${helpOf(option)}`.toLowerCase().includes(words));
    const groups = [...new Set(shown.map((option) => option.group))];
    return html`<div class="row">
        <span class="in s find grow">
          ${icon("find")}
          <input
            type="search"
            aria-label="Find an option"
            placeholder="Find an option"
            .value=${this.find}
            @input=${(event: Event) => {
              this.find = (event.target as HTMLInputElement).value;
            }}
          />
        </span>
        ${
          set > 0
            ? html`<button type="button" class="link small" @click=${() => this.reset(options)}>All to defaults</button>`
            : nothing
        }
      </div>
      ${groups.map(
        (group) =>
          html`<h4>${groupTitle(group)}</h4>
            ${shown.filter((option) => option.group === group).map((option) => this.option(option))}`,
      )}
      ${shown.length === 0 ? html`<p class="small dim">No option says “${this.find}”.</p>` : nothing}`;
  }

  private reset(options: readonly Option[]): void {
    this.problems.clear();
    this.session.editWithToast("Options are at their defaults.", (draft) =>
      options
        .filter((option) => this.isSet(option))
        .reduce((next, option) => setOption(next, option.name, undefined), draft),
    );
  }

  private set(option: Option, value: Json | undefined): void {
    this.session.edit((draft) => setOption(draft, option.name, value), `option ${option.name}`);
  }

  private option(option: Option): TemplateResult {
    const value = getOption(this.session.draft, option.name);
    const problem = this.problems.get(option.name);
    return html`<div class="field option ${this.isSet(option) ? "set" : ""}">
      <span class=${this.isSet(option) ? "b" : "dim"}>${label(option.name)}</span>
      ${this.control(option, value)} ${problem ? html`<span class="range" role="alert">${problem}</span>` : nothing}
      <span class="hint">${helpOf(option)}</span>
    </div>`;
  }

  private control(option: Option, value: Json | undefined): TemplateResult {
    switch (fieldKind(option)) {
      case "switch": {
        const usually = onByDefault(option);
        const on = typeof value === "boolean" ? value : usually;
        return toggle(label(option.name), on, (next) => this.set(option, next === usually ? undefined : next));
      }
      case "choice":
        return this.choice(option, value);
      default:
        return this.typed(option, value);
    }
  }

  private choice(option: Option, value: Json | undefined): TemplateResult {
    const text = optionText(value);
    const known = choices(option);
    const own = text !== "" && !known.includes(text) ? [text] : [];
    const first = defaultChoice(option);
    return select(
      label(option.name),
      [
        { value: usual, text: first ? `${first} (default)` : option.default ? `${defaultText(option)}` : "default" },
        ...[...known, ...own].filter((word) => word !== first).map((word) => ({ value: word, text: word })),
      ],
      text === first ? usual : text,
      (next) => this.set(option, next === usual ? undefined : next),
      "n wider",
    );
  }

  private typed(option: Option, value: Json | undefined): TemplateResult {
    const words = [option.none_word, option.zero_word].filter((word) => word !== "");
    const list = `words-${option.name}`;
    return html`<span class="in n wider ${this.problems.has(option.name) ? "wrong" : ""}"
      ><input
        type="text"
        autocomplete="off"
        spellcheck="false"
        list=${words.length > 0 ? list : nothing}
        aria-label=${label(option.name)}
        placeholder=${defaultText(option) || "none"}
        .value=${optionText(value)}
        @change=${(event: Event) => this.read(option, event.target as HTMLInputElement)} />${
          words.length > 0
            ? html`<datalist id=${list}>${words.map((word) => html`<option value=${word}></option>`)}</datalist>`
            : nothing
        }</span
    >`;
  }

  private read(option: Option, input: HTMLInputElement): void {
    const read = readOption(option, input.value);
    if ("problem" in read) {
      this.problems.set(option.name, read.problem);
    } else {
      this.problems.delete(option.name);
      this.set(option, read.value);
    }
    this.requestUpdate();
  }
}
