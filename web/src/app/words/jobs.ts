/// How a job stands, in words: for the list of jobs and the top bar.

import type { Job } from "../../api/types";
import { copies, count, percent } from "./numbers";
import { phaseText } from "./phases";
import { sentence } from "./sentence";
import { duration, timeOfDay } from "./times";

export type Tone = "ok" | "warn" | "bad" | "run" | "plain";

export interface StateWords {
  readonly tone: Tone;
  readonly text: string;
}

/// How far a running job is, from 0 to 1.
export function shareDone(job: Job): number {
  const progress = job.progress;
  return progress && progress.total > 0 ? Math.min(1, progress.done / progress.total) : 0;
}

/// The verdict on what stands, or null where there is none yet.
export function verdictWords(job: Job): StateWords | null {
  const verdict = job.verdict;
  if (!verdict) return null;
  if (verdict.apart === "no") return { tone: "bad", text: "Does not come apart" };
  if (!verdict.ok) return { tone: "bad", text: "Check failed" };
  if (verdict.apart === "not_checked") return { tone: "warn", text: "Coming apart: not checked" };
  return { tone: "ok", text: "Comes apart" };
}

export function stateWords(job: Job): StateWords {
  switch (job.status) {
    case "new":
      return { tone: "plain", text: "Not packed yet" };
    case "queued":
      return { tone: "plain", text: job.queue_place ? `Waiting: place ${job.queue_place}` : "Waiting" };
    case "running":
      return { tone: "run", text: packingWords(job) };
    case "failed":
      return { tone: "bad", text: "Failed" };
    case "interrupted":
      return { tone: "warn", text: "Interrupted" };
    case "cancelled":
      return job.has_packing
        ? (verdictWords(job) ?? { tone: "warn", text: "Stopped" })
        : { tone: "warn", text: "Stopped" };
    default:
      return verdictWords(job) ?? { tone: "plain", text: "Packed" };
  }
}

/// "Packing 62 %" while copies are placed; what else it does, by its name.
function packingWords(job: Job): string {
  const phase = job.progress?.phase;
  if (phase === "search") return `Packing ${percent(shareDone(job), 0)}`;
  if (phase === "improve") return "Improving";
  if (phase === "disassemble" || phase === "reinsert" || phase === "check") return "Checking";
  if (phase === "render" || phase === "write") return "Writing";
  return "Packing";
}

/// The line of figures under a job's name.
export function figures(job: Job): string {
  if (job.status === "failed" && job.error) return sentence(job.error);
  const progress = job.progress;
  if (job.status === "running" && progress) {
    const left = typeof progress.left === "number" ? ` · about ${duration(progress.left)} left` : "";
    if (progress.phase === "search") return `${count(progress.done)} of ${count(progress.total)} placed${left}`;
    return `${phaseText(progress.phase)}${left}`;
  }
  const summary = job.summary;
  if (summary) {
    return `${count(summary.placed)} of ${copies(summary.copies)} · ${percent(summary.density)} full`;
  }
  return job.files === 0 ? "no files yet" : job.files === 1 ? "1 file" : `${count(job.files)} files`;
}

/// The line above it: printer or size, and trays.
export function place(job: Job): string {
  const trays = job.summary && job.summary.trays > 1 ? ` · ${job.summary.trays} trays` : "";
  return (job.tray ?? "No tray chosen yet") + trays;
}

export function interruptedText(job: Job): string {
  return `Interrupted ${timeOfDay(new Date(job.changed))}`;
}
