/// Starts what packs: anew, round copies that stay, or to make a packing better.

import { api } from "../../api/client";
import type { Start } from "../../api/types";
import { copyOfId } from "../change/locks";
import type { Packs } from "../change/repacks";
import { attempt, tell } from "./app_state";
import { keep } from "./kept";
import { fingerprint } from "./new_draft";
import { go } from "./route";
import type { Session } from "./session";

/// Which copies stay where they are.
export type Keeps = "none" | "locked" | "all";

/// Packs what the draft says, and shows it.
export async function startPacking(session: Session, keeps: Keeps): Promise<void> {
  const { draft, id, saver, work } = session;
  if (session.locked || work.unchecked || draft.parts.length === 0) return;
  if (!(await saver.flush())) {
    tell(saver.state.value.problem);
    return;
  }
  const locked = [...work.state.value.locks].map(copyOfId);
  const how: Start | null = keeps === "none" ? null : { keep: keeps === "all" ? "all" : locked };
  if (!(await begin(session, keeps === "none" ? "anew" : "keeps", how))) return;
  keep(`packed.${id}`, fingerprint(session.draft));
  session.build.set({ follow: true, selected: [], section: null, find: null });
  go({ page: "job", id, step: "build" });
}

/// Makes the packing that stands better for so many seconds.
export async function startImproving(session: Session, seconds: number): Promise<void> {
  if (!session.locked && !session.work.unchecked) await begin(session, "improves", { improve: seconds });
}

async function begin(session: Session, packs: Packs, how: Start | null): Promise<boolean> {
  session.work.packs(packs);
  const started = await attempt(async () => {
    await session.run.start(packs === "improves" ? "improve" : "pack", () => api.start(session.id, how));
    return true;
  });
  session.work.started(started === true, packs);
  return started === true;
}
