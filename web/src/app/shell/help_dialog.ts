/// What the page is for, its keys as they hold on this screen, and how to use the mouse.

import { html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { toggle } from "../common/bits";
import { icon } from "../common/icons";
import { Piece } from "../common/piece";
import { app, setLetterKeys } from "../state/app_state";
import { currentKeys } from "./keys";

const mouse: readonly (readonly [string, string])[] = [
  ["Left button", "turns the view"],
  ["Middle button, Shift+left", "shifts it"],
  ["Wheel", "zooms to the pointer"],
  ["Click", "selects a copy; with Ctrl one more"],
  ["Double click", "frames it"],
  ["Touch", "one finger turns, two shift, pinch zooms, tap selects"],
];

@customElement("sp-help")
export class Help extends Piece {
  @query("dialog") private readonly dialog!: HTMLDialogElement;

  protected override stores() {
    return [app];
  }

  protected override firstUpdated(): void {
    this.dialog.showModal();
  }

  override render() {
    return html`<dialog class="dialog" aria-labelledby="help-title" @close=${() => app.set({ dialog: null })}>
      <div class="head">
        <h2 id="help-title" class="grow">Help</h2>
        <button type="button" class="btn ghost icon" aria-label="Close" @click=${() => this.dialog.close()}>
          ${icon("close")}
        </button>
      </div>
      <div class="scroll">
        <section class="sec">
          <p>
            Bring the parts, choose the printer, press Pack. Copies are placed as densely as they go, each at least the
            gap from the others, and so that all of them can be taken out again one after the other. The result is
            checked on the exact meshes before it can be exported.
          </p>
        </section>
        <section class="sec">
          <h3>Keys on this screen</h3>
          <dl class="keys">
            ${currentKeys().map(
              (key) =>
                html`<dt>${key.keys.map((name, i) => html`${i > 0 ? " " : ""}<kbd>${name}</kbd>`)}</dt>
                  <dd>${key.does}</dd>`,
            )}
          </dl>
          <div class="field">
            <span class="dim">Keys of one letter</span>
            ${toggle("Keys of one letter", app.value.letterKeys, setLetterKeys)}
          </div>
        </section>
        <section class="sec">
          <h3>Mouse and touch</h3>
          <dl class="keys">${mouse.map(([what, does]) => html`<dt>${what}</dt><dd>${does}</dd>`)}</dl>
        </section>
        <section class="sec">
          <p class="small faint">
            ${app.value.info?.program ?? "spectralpack"} ·
            <a class="link" href="./openapi.json" download="openapi.json">API description</a>
          </p>
        </section>
      </div>
    </dialog>`;
  }
}
