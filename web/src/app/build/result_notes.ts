/// What stays true about a result and wants something done: cut off, stopped, out of time, changed since, nearly empty.

import { html, nothing, type TemplateResult } from "lit";
import { type IconName, icon } from "../common/icons";
import type { Packing } from "../state/packing";
import type { Session } from "../state/session";
import { news } from "../words/news";
import { copies, count } from "../words/numbers";
import { sentence } from "../words/sentence";
import { duration, timeOfDay } from "../words/times";

interface Act {
  readonly text: string;
  readonly run: () => void;
}

function note(
  tone: "warn" | "bad" | "info",
  name: IconName,
  bold: string,
  text: string,
  acts: readonly Act[],
): TemplateResult {
  return html`<div class="note ${tone}" role="status">
    ${icon(name)}
    <div>
      <p><b>${bold}</b> ${text}</p>
      ${
        acts.length > 0
          ? html`<div class="row wrap">
              ${acts.map((act) => html`<button type="button" class="btn s" @click=${act.run}>${act.text}</button>`)}
            </div>`
          : nothing
      }
    </div>
  </div>`;
}

export function notes(session: Session, packing: Packing, tray: number): TemplateResult | typeof nothing {
  const all = [...ends(session, packing), ...changed(session), ...nearlyEmpty(session, packing, tray)];
  const remarks = news(session.job.remarks);
  if (all.length === 0 && remarks.length === 0) return nothing;
  return html`<section class="sec stack">
    ${all}
    ${
      remarks.length > 0
        ? html`<ul class="said">
            ${remarks.map((text) => html`<li>${text}</li>`)}
          </ul>`
        : nothing
    }
  </section>`;
}

/// How the run ended, where that is not by being done.
function ends(session: Session, packing: Packing): TemplateResult[] {
  const { job, draft } = session;
  const again = { text: "Pack again", run: () => void session.pack() };
  const untried = packing.leftOver
    .filter((row) => row.reason === "not_tried" && !row.byHand)
    .reduce((sum, row) => sum + row.copies, 0);
  if (job.status === "interrupted") {
    const when = timeOfDay(new Date(job.changed));
    return [
      note(
        "warn",
        "warn",
        `Interrupted at ${when}.`,
        "The computer or the program stopped. This is the best packing so far.",
        [{ text: "Continue packing", run: () => void session.goOn() }],
      ),
    ];
  }
  if (job.status === "cancelled" && packing.improvement) {
    return [note("info", "info", "Stopped.", "The best build that was found is kept.", [])];
  }
  if (job.status === "cancelled") {
    return [
      note("info", "info", "Stopped.", "This is the best packing so far.", [
        { text: "Go on packing", run: () => void session.goOn() },
      ]),
    ];
  }
  if (job.status === "failed") {
    return [note("bad", "bad", "The run failed.", job.error ? sentence(job.error) : "", [again])];
  }
  if (untried > 0 && draft.timeLimit !== null) {
    const longer = draft.timeLimit * 2;
    return [
      note(
        "warn",
        "clock",
        `Time limit of ${duration(draft.timeLimit)} reached.`,
        `This is the best packing found; ${copies(untried)} ${untried === 1 ? "was" : "were"} not tried.`,
        [
          {
            text: `Pack again with ${duration(longer)}`,
            run: () => void session.packWith({ ...draft, timeLimit: longer }),
          },
        ],
      ),
    ];
  }
  return [];
}

function changed(session: Session): TemplateResult[] {
  if (!session.changedSince) return [];
  return [note("info", "info", "Parts or settings have changed since.", "This build does not have the changes.", [])];
}

/// A last tray that holds next to nothing: perhaps not worth a print.
function nearlyEmpty(session: Session, packing: Packing, tray: number): TemplateResult[] {
  const last = packing.trays[packing.trays.length - 1];
  if (tray !== 0 || !last || packing.trays.length < 2 || !isNearlyEmpty(packing, last.number)) return [];
  const fewer = packing.trays.length - 1;
  return [
    note(
      "warn",
      "warn",
      `Tray ${last.number} holds ${copies(last.placements.length)}.`,
      "It may not be worth a print.",
      [
        {
          text: fewer === 1 ? "Pack again with 1 tray" : `Pack again with ${count(fewer)} trays`,
          run: () => void session.packWith({ ...session.draft, trays: fewer }),
        },
      ],
    ),
  ];
}

export function isNearlyEmpty(packing: Packing, number: number): boolean {
  const tray = packing.trays[number - 1];
  const fullest = Math.max(...packing.trays.map((own) => own.density));
  return tray !== undefined && packing.trays.length > 1 && tray.density < fullest / 8;
}
