/// New jobs: from files, from the sample, from another job.

import { api } from "../../api/client";
import { attempt } from "./app_state";
import { jobName, type PickedFile, shortName } from "./file_names";
import { madeHere, openJob } from "./open_job";
import { go } from "./route";

export async function jobFromFiles(picked: readonly PickedFile[]): Promise<void> {
  if (picked.length === 0) return;
  await attempt(async () => {
    const job = await api.createJob({ name: jobName(picked, new Date()) });
    madeHere(job.id);
    const session = await openJob(job.id);
    session?.addFiles(picked);
    go({ page: "job", id: job.id, step: "parts" });
  });
}

export async function jobFromSample(): Promise<void> {
  await attempt(async () => {
    // It comes with a job file, which says how many of each.
    const job = await api.createJob({ name: "Sample", sample: true });
    go({ page: "job", id: job.id, step: "parts" });
  });
}

export async function copyOf(id: string, name: string): Promise<void> {
  await attempt(async () => {
    const job = await api.createJob({ copy_of: id, name: shortName(`${name} copy`) });
    go({ page: "job", id: job.id, step: "parts" });
  });
}
