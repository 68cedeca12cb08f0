/// What was just done, with Undo, for five seconds.

import { html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { Piece } from "../common/piece";
import { app } from "../state/app_state";
import { hold } from "../state/toasts";

@customElement("sp-toast")
export class ToastBox extends Piece {
  protected override stores() {
    return [app];
  }

  override render() {
    const toast = app.value.toast;
    return html`<div class="toasts" role="status" aria-live="polite">
      ${
        toast
          ? html`<div
              class="toast"
              @pointerenter=${() => hold(true)}
              @pointerleave=${() => hold(false)}
              @focusin=${() => hold(true)}
              @focusout=${() => hold(false)}
            >
              <span class="cut">${toast.text}</span>
              <button type="button" class="btn s" @click=${toast.undo}>Undo</button>
            </div>`
          : nothing
      }
    </div>`;
  }
}
