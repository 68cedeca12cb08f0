/// Files that cannot be used, above the good ones: why, and what to do about each.

import { html, nothing, type TemplateResult } from "lit";
import { chooseFiles } from "../common/files_button";
import { icon } from "../common/icons";
import type { Session } from "../state/session";
import { counted } from "../words/numbers";
import { sentence } from "../words/sentence";

export interface BadRow {
  readonly file: string;
  readonly error: string;
}

export function badFiles(session: Session): BadRow[] {
  const { refused, dismissed } = session.state.value;
  const read = session.parts.bad.map(({ file, error, place }) => ({
    file,
    error: sentence(place ? `${place}: ${error}` : error),
  }));
  return [...refused, ...read].filter(({ file }) => !dismissed.has(file));
}

/// Set files that name meshes which are not there.
function missing(session: Session): string[] {
  return session.parts.sets
    .filter((set) => set.missing.length > 0 && !session.state.value.dismissed.has(set.file))
    .map(
      (set) =>
        `${set.file} names ${counted(set.missing.length, "file")} that ${set.missing.length === 1 ? "is" : "are"} not here: ${someOf(set.missing)}.`,
    );
}

function someOf(names: readonly string[]): string {
  const shown = names.slice(0, 3).join(", ");
  return names.length > 3 ? `${shown} and ${names.length - 3} more` : shown;
}

export function filesBanner(session: Session, good: number): TemplateResult {
  const bad = badFiles(session);
  const all = bad.length + session.parts.meshes.length;
  return html`${
    bad.length > 0
      ? html`<div class="banner bad" role="status">
          ${icon("bad")}
          <span class="grow">
            <b>${bad.length} of ${counted(Math.max(all, bad.length), "file")} cannot be used.</b>
            ${good > 0 ? html`<span class="dim">The other parts are ready to pack.</span>` : nothing}
          </span>
          <button type="button" class="btn s" @click=${() => session.leaveOutFiles(bad.map(({ file }) => file))}>
            ${bad.length === 1 ? "Leave it out" : bad.length === 2 ? "Leave both out" : "Leave all out"}
          </button>
        </div>`
      : nothing
  }${missing(session).map(
    (text) =>
      html`<div class="banner warn" role="status">
        ${icon("warn")}<span class="grow">${text}</span>
        <button type="button" class="btn s" @click=${() => chooseFiles((files) => session.addFiles(files))}>Add them</button>
      </div>`,
  )}`;
}

export function badFileRows(session: Session): TemplateResult[] {
  return badFiles(session).map(
    ({ file, error }) =>
      html`<div class="pr bad-file" role="row">
        <span role="gridcell" class="c-check bad-text">${icon("bad")}</span>
        <span role="gridcell" class="nm">
          <b class="cut">${file}</b>
          <span class="cut bad-text" title=${error}>${error}</span>
        </span>
        <span role="gridcell" class="row">
          <button
            type="button"
            class="btn s"
            @click=${() =>
              chooseFiles(([picked]) => picked && session.replaceFile(file, picked.file), { several: false })}
          >
            Replace
          </button>
          <button type="button" class="btn s" @click=${() => session.leaveOutFiles([file])}>Leave out</button>
        </span>
      </div>`,
  );
}
