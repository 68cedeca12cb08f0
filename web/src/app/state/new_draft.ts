/// What a new job begins with, and how drafts are told apart.

import type { Info } from "../../api/types";
import { type Draft, emptyDraft, type TrayChoice } from "./draft";
import { toJobFile } from "./job_file_write";
import { kept } from "./kept";

/// Short, and another one for another job file.
export function fingerprint(draft: Draft): string {
  let hash = 0x811c9dc5;
  for (const c of JSON.stringify(toJobFile(draft))) hash = Math.imul(hash ^ (c.codePointAt(0) ?? 0), 0x01000193);
  return (hash >>> 0).toString(16);
}

/// The printer that was used last, or the first that keeps a gap, as real ones do.
export function usualPrinter(info: Info): TrayChoice | null {
  const last = kept<string | null>("printer", null);
  const printer = info.printers.find(({ name }) => name === last) ?? info.printers.find(({ gap }) => gap > 0);
  return printer ? { kind: "printer", name: printer.name } : null;
}

export function newDraft(info: Info): Draft {
  return { ...emptyDraft, tray: usualPrinter(info) ?? emptyDraft.tray };
}
