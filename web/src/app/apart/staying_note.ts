/// Copies that the plan has no step for, and steps through the walls: said once, below the step.

import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../common/icons";
import { copies, counted } from "../words/numbers";
import type { Apart } from "./apart";

export function incomplete({ plan, tray }: Apart): TemplateResult | typeof nothing {
  const fixed = plan.staying.filter((index) => tray.placements[index]?.fixed).length;
  const lost = plan.staying.length - fixed;
  const walls = plan.steps.filter((step) => step.throughWalls).length;
  if (plan.staying.length === 0 && walls === 0) return nothing;
  return html`<section class="sec stack">
    ${
      lost > 0
        ? html`<div class="note warn">
            ${icon("warn")}
            <p>
              <b>The plan is not complete.</b> For ${copies(lost)} no way out is known. They stay in the tray and stand at
              the end of the list.
            </p>
          </div>`
        : nothing
    }
    ${
      fixed > 0
        ? html`<p class="small dim">${copies(fixed)} ${fixed === 1 ? "is" : "are"} fixed and ${fixed === 1 ? "stays" : "stay"} where ${fixed === 1 ? "it is" : "they are"}.</p>`
        : nothing
    }
    ${
      walls > 0
        ? html`<p class="small dim">
            ${counted(walls, "step")} ${walls === 1 ? "leads" : "lead"} through the walls: open the tray at a side for
            ${walls === 1 ? "it" : "them"}.
          </p>`
        : nothing
    }
  </section>`;
}
