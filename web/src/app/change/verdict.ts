/// The verdict on what is shown, which may be changed since it was checked, and whether it can be exported.

import type { Session } from "../state/session";
import { type StateWords, verdictWords } from "../words/jobs";

/// Null where there is none yet.
export function shownVerdict(session: Session): StateWords | null {
  if (session.run.checking) return { tone: "run", text: "Checking" };
  if (session.work.unchecked) return { tone: "warn", text: "Changed: not checked" };
  return verdictWords(session.job);
}

/// Why nothing is exported now; null: it is.
export function exportHeld(session: Session): string | null {
  const { verdict } = session.job;
  if (session.run.checking) return "The change is being checked: export follows";
  if (session.work.unchecked) return "The build is changed: it is checked before it can be exported";
  return verdict !== null && !verdict.ok && verdict.findings.length > 0
    ? "The check found faults: nothing is exported"
    : null;
}
