/// What is filled: a printer's tray, a box, or the inside of a mesh; and how many of it.

import { html, nothing, type TemplateResult } from "lit";
import { checkBox, segments, select, toggle } from "../common/bits";
import { chooseFiles } from "../common/files_button";
import type { ValueEvent } from "../common/number_field";
import "../common/number_field";
import "../common/stepper";
import { holdsAllInOne, type Sides, type TrayChoice, usualTray } from "../state/draft";
import { removeParts, setTray } from "../state/draft_edit";
import { keep } from "../state/kept";
import { usualPrinter } from "../state/new_draft";
import type { Session } from "../state/session";
import { gapOf, traySize, wallGapOf } from "../state/tray_size";
import { size } from "../words/numbers";

type Kind = TrayChoice["kind"];

export function trayFields(session: Session): TemplateResult {
  const { draft } = session;
  return html`${segments<Kind>(
    "Tray",
    [
      { value: "printer", text: "Printer", disabled: session.info.printers.length === 0 },
      { value: "box", text: "Box" },
      { value: "mesh", text: "Mesh" },
    ],
    draft.tray.kind,
    (kind) =>
      session.edit((before) => {
        const next = setTray(before, trayOfKind(session, kind));
        // A box keeps the gaps of the printer before it; another printer brings its own.
        if (before.tray.kind !== "printer" || kind === "printer") return next;
        return { ...next, gap: gapOf(before, session.info), wallGap: wallGapOf(before, session.info) };
      }),
  )}
  ${draft.tray.kind === "printer" ? printer(session) : draft.tray.kind === "box" ? box(session, draft.tray.size) : mesh(session)}
  ${draft.tray.kind === "mesh" ? nothing : ceiling(session)} ${trays(session)}`;
}

function trayOfKind(session: Session, kind: Kind): TrayChoice {
  const { draft, info, parts } = session;
  if (draft.tray.kind === kind) return draft.tray;
  if (kind === "printer") return usualPrinter(info) ?? draft.tray;
  if (kind === "box") return { kind, size: rounded(traySize(draft, info, parts.meshes) ?? usualTray) };
  return { kind, file: null, is: null, unit: null, transform: null };
}

/// Up to a tenth of a millimetre, so that what fitted still does.
function rounded(sides: Sides): Sides {
  const up = (side: number) => Math.ceil(side * 10 - 1e-6) / 10;
  return [up(sides[0]), up(sides[1]), up(sides[2])];
}

function printer(session: Session): TemplateResult {
  const { draft, info } = session;
  const name = draft.tray.kind === "printer" ? draft.tray.name : "";
  const sides = traySize(draft, info, []);
  const known = info.printers.some((own) => own.name === name);
  return html`${select(
    "Printer",
    [
      ...info.printers.map((own) => ({
        value: own.name,
        text: own.title.charAt(0).toUpperCase() + own.title.slice(1),
      })),
      ...(known ? [] : [{ value: name, text: `${name}: not known here` }]),
    ],
    name,
    (next) => {
      keep("printer", next);
      session.edit((before) => ({ ...before, tray: { kind: "printer", name: next }, gap: null, wallGap: null }));
    },
    "wide",
  )}
    <div class="field"><span class="dim">Size</span><span>${sides ? size(sides) : "unknown"}</span></div>`;
}

function box(session: Session, sides: Sides): TemplateResult {
  const side = (axis: 0 | 1 | 2, label: string) =>
    html`<sp-number
      label=${`${label}, mm`}
      classes="third"
      .value=${sides[axis]}
      .least=${0}
      above
      .most=${100_000}
      ?disabled=${axis === 2 && session.draft.openHeight}
      @value=${(event: ValueEvent) => {
        const next: [number, number, number] = [...sides];
        next[axis] = event.detail ?? sides[axis];
        session.edit((before) => ({ ...before, tray: { kind: "box", size: next } }), `box ${axis}`);
      }}
    ></sp-number>`;
  return html`<div class="thirds" role="group" aria-label="Size of the box, mm">
    ${side(0, "Length")}<span class="faint">×</span>${side(1, "Width")}<span class="faint">×</span>${side(2, "Height")}
    <span class="faint">mm</span>
  </div>`;
}

function ceiling(session: Session): TemplateResult {
  const { draft } = session;
  const possible = draft.keepOut.length === 0;
  return html`<div class="field">
    <span class="dim">No ceiling</span>
    ${toggle(
      "No ceiling: as low as can be on the base",
      draft.openHeight,
      (openHeight) => session.edit((before) => ({ ...before, openHeight })),
      !possible,
    )}
    ${
      draft.openHeight
        ? html`<span class="hint">As low as can be on the base, however high that is.</span>`
        : possible
          ? nothing
          : html`<span class="hint">Not with keep-out zones.</span>`
    }
  </div>`;
}

function trays(session: Session): TemplateResult {
  const { draft } = session;
  if (holdsAllInOne(draft)) {
    return html`<div class="field">
      <span class="dim">Trays</span><span>1</span>
      <span class="hint">${draft.openHeight ? "Without a ceiling one tray holds all." : "The least box holds all."}</span>
    </div>`;
  }
  const number = draft.trays;
  const all = number === "all";
  return html`<div class="field">
    <span class="dim">Trays</span>
    <span class="row">
      ${
        all
          ? nothing
          : html`<sp-stepper
              label="trays"
              .value=${number}
              .most=${1000}
              @value=${(event: ValueEvent) =>
                session.edit((before) => ({ ...before, trays: event.detail ?? 1 }), "trays")}
            ></sp-stepper>`
      }
      <button
        type="button"
        class="btn s ${all ? "on" : ""}"
        aria-pressed=${all}
        title="As many trays as it takes"
        @click=${() => session.edit((before) => ({ ...before, trays: all ? 1 : "all" }))}
      >
        As many as needed
      </button>
    </span>
  </div>`;
}

function mesh(session: Session): TemplateResult {
  const { draft, parts } = session;
  const tray = draft.tray;
  if (tray.kind !== "mesh") return html``;
  const files = [...new Set(parts.meshes.map((own) => own.file))];
  const sides = traySize(draft, session.info, parts.meshes);
  const take = (file: string) =>
    session.edit((before) => {
      // What is filled is not packed as well.
      const own = new Set(before.parts.filter((part) => part.file === file).map((part) => part.key));
      return setTray(removeParts(before, own), { ...tray, file });
    });
  return html`${
    files.length > 0
      ? select(
          "Mesh to fill",
          [
            ...(tray.file !== null && !files.includes(tray.file)
              ? [{ value: tray.file, text: `${tray.file}: not there` }]
              : []),
            ...files.map((file) => ({ value: file, text: file })),
          ],
          tray.file,
          take,
          "wide",
        )
      : html`<p class="faint small">A closed mesh that is filled instead of a box.</p>`
  }
    <button
      type="button"
      class="btn s"
      @click=${() =>
        chooseFiles(
          ([picked]) => {
            if (!picked) return;
            session.addFiles([picked]);
            take(picked.file.name);
          },
          { several: false, accept: ".stl,.3mf,.obj,.ply,.off" },
        )}
    >
      Choose a file
    </button>
    <div class="field"><span class="dim">Size</span><span>${sides ? size(sides) : "–"}</span></div>
    <div class="field">
      <span class="dim">Filled is</span>
      ${select<"auto" | "solid" | "vessel">(
        "What of the mesh is filled",
        [
          { value: "auto", text: "by its shape" },
          { value: "solid", text: "its own volume" },
          { value: "vessel", text: "what it holds" },
        ],
        tray.is ?? "auto",
        (is) => session.edit((before) => setTray(before, { ...tray, is: is === "auto" ? null : is })),
        "n wider",
      )}
    </div>
    <label class="row">
      ${checkBox("Its walls are really there", draft.physical, (physical) =>
        session.edit((before) => ({ ...before, physical })),
      )}
      <span>Its walls are really there</span>
    </label>
    ${draft.physical ? html`<p class="faint small">Copies leave over the top, which is open.</p>` : nothing}`;
}
