/// Which job is open.

import { api } from "../../api/client";
import { app } from "./app_state";
import { Session } from "./session";
import { Store } from "./store";

/// The job that is open, where one is.
export const open = new Store<{ session: Session | null; problem: string | null }>({ session: null, problem: null });

let opening = "";
/// Made by this page, and not opened yet.
const made = new Set<string>();

export function madeHere(id: string): void {
  made.add(id);
}

/// Opens a job, or keeps it where it is open already.
export async function openJob(id: string): Promise<Session | null> {
  if (open.value.session?.id === id) return open.value.session;
  if (opening === id) return null;
  closeJob();
  opening = id;
  try {
    const info = app.value.info ?? (await api.info());
    app.set({ info });
    const session = new Session(info, await api.job(id));
    await session.open(made.delete(id));
    if (opening !== id) {
      session.close();
      return null;
    }
    open.set({ session, problem: null });
    return session;
  } catch (error) {
    if (opening === id) open.set({ problem: error instanceof Error ? error.message : "The job cannot be opened." });
    return null;
  } finally {
    if (opening === id) opening = "";
  }
}

export function closeJob(): void {
  opening = "";
  open.value.session?.close();
  open.set({ session: null, problem: null });
}
