/// The jobs of this server, asked again every two seconds while the page is looked at.

import { api } from "../../api/client";
import type { Job } from "../../api/types";
import { attempt } from "./app_state";
import { keep, kept } from "./kept";
import { isRunning } from "./runner";
import { Store } from "./store";
import { toast } from "./toasts";

export interface JobListState {
  readonly jobs: readonly Job[] | null;
  readonly total: number;
  readonly bytes: number;
  readonly find: string | null;
  readonly all: boolean;
  /// About to be deleted.
  readonly going: ReadonlySet<string>;
  readonly dismissed: readonly string[];
  readonly failed: boolean;
}

const few = 6;
const many = 500;
const every = 2000;

export const jobList = new Store<JobListState>({
  jobs: null,
  total: 0,
  bytes: 0,
  find: null,
  all: false,
  going: new Set(),
  dismissed: kept<string[]>("dismissed", []),
  failed: false,
});

let timer = 0;
let watched = 0;

export async function refreshJobs(): Promise<void> {
  const { find, all } = jobList.value;
  try {
    const list = await api.jobs(find ?? "", all || find ? many : few);
    jobList.set({ jobs: list.jobs, total: list.total, bytes: list.bytes, failed: false });
  } catch {
    jobList.set({ failed: true });
  }
}

/// Until the returned function is called.
export function watchJobs(): () => void {
  watched += 1;
  const loop = async () => {
    if (!document.hidden) await refreshJobs();
    if (watched > 0) timer = window.setTimeout(loop, every);
  };
  const seen = () => {
    if (!document.hidden) void refreshJobs();
  };
  document.addEventListener("visibilitychange", seen);
  void loop();
  return () => {
    watched -= 1;
    clearTimeout(timer);
    document.removeEventListener("visibilitychange", seen);
  };
}

export function findJobs(find: string | null): void {
  jobList.set({ find });
  void refreshJobs();
}

export function showAllJobs(all: boolean): void {
  jobList.set({ all });
  void refreshJobs();
}

/// It is gone from the list at once, and from the server once the toast is over.
export function deleteLater(job: Job): void {
  jobList.set({ going: new Set([...jobList.value.going, job.id]) });
  const back = () => {
    const going = new Set(jobList.value.going);
    going.delete(job.id);
    jobList.set({ going });
  };
  toast(`“${job.name}” is deleted${isRunning(job) ? ", and stopped" : ""}.`, back, () => {
    void attempt(() => api.deleteJob(job.id))
      .then(refreshJobs)
      .then(back);
  });
}

const mark = (job: Job): string => `${job.id} ${job.changed}`;

/// Jobs that were interrupted and that nobody has said anything about yet.
export function interrupted(state: JobListState): Job[] {
  return (state.jobs ?? []).filter(
    (job) => job.status === "interrupted" && !state.going.has(job.id) && !state.dismissed.includes(mark(job)),
  );
}

export function dismiss(job: Job): void {
  const dismissed = [...jobList.value.dismissed.slice(-50), mark(job)];
  keep("dismissed", dismissed);
  jobList.set({ dismissed });
}
