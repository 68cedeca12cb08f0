/// The server's answers as values. What goes wrong is an ApiError whose message is a sentence for people.

import createClient from "openapi-fetch";
import { sentence } from "../app/words/sentence";
import type { paths } from "./schema";
import type { Change, Clearance, Detail, Estimate, Info, Job, JobList, JsonObject, Parts, Start } from "./types";

export class ApiError extends Error {
  constructor(
    message: string,
    /// 0: the server did not answer.
    readonly status: number,
    readonly file: string | null = null,
  ) {
    super(message);
  }
}

export const noAnswer = "The server does not answer. It may have been stopped: start spectralpack serve again.";

/// Told of every answer: whether the server is there, and whether it asks for the token.
export interface Listener {
  reached(there: boolean): void;
  tokenWanted(): void;
}

let listener: Listener = { reached() {}, tokenWanted() {} };

export function listen(to: Listener): void {
  listener = to;
}

const client = createClient<paths>({ baseUrl: "./", credentials: "same-origin" });

interface Answer {
  readonly data?: unknown;
  readonly error?: unknown;
  readonly response: Response;
}

/// Shared with uploads, which do not go through the client.
export function errorOf(status: number, body: unknown): ApiError {
  listener.reached(true);
  if (status === 401) listener.tokenWanted();
  const said = body as { error?: unknown; file?: unknown } | null | undefined;
  const text =
    typeof said?.error === "string" && said.error ? sentence(said.error) : `The server answered ${status}. Try again.`;
  return new ApiError(text, status, typeof said?.file === "string" ? said.file : null);
}

async function ask(call: Promise<Answer>): Promise<unknown> {
  let answer: Answer;
  try {
    answer = await call;
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw error;
    listener.reached(false);
    throw new ApiError(noAnswer, 0);
  }
  if (!answer.response.ok) throw errorOf(answer.response.status, answer.error);
  listener.reached(true);
  return answer.data;
}

const of = (id: string) => ({ path: { id } });

export const api = {
  info: () => ask(client.GET("/api/info")) as Promise<Info>,

  startSession: (token: string) => ask(client.POST("/api/session", { body: { token } })) as Promise<undefined>,

  jobs: (find: string, most: number) =>
    ask(client.GET("/api/jobs", { params: { query: { most, ...(find ? { find } : {}) } } })) as Promise<JobList>,

  createJob: (job: { name?: string; sample?: boolean; copy_of?: string }) =>
    ask(client.POST("/api/jobs", { body: job })) as Promise<Job>,

  job: (id: string) => ask(client.GET("/api/jobs/{id}", { params: of(id) })) as Promise<Job>,

  rename: (id: string, name: string) =>
    ask(client.PATCH("/api/jobs/{id}", { params: of(id), body: { name } })) as Promise<Job>,

  deleteJob: (id: string) => ask(client.DELETE("/api/jobs/{id}", { params: of(id) })) as Promise<undefined>,

  deleteFile: (id: string, name: string) =>
    ask(client.DELETE("/api/jobs/{id}/files/{name}", { params: { path: { id, name } } })) as Promise<undefined>,

  fileBytes: (id: string, name: string) =>
    ask(
      client.GET("/api/jobs/{id}/files/{name}", { params: { path: { id, name } }, parseAs: "arrayBuffer" }),
    ) as Promise<ArrayBuffer>,

  parts: (id: string) => ask(client.GET("/api/jobs/{id}/parts", { params: of(id) })) as Promise<Parts>,

  meshes: (id: string, detail: Detail, ids: readonly number[]) =>
    ask(
      client.GET("/api/jobs/{id}/meshes.bin", {
        params: { ...of(id), query: { detail, ids: ids.join(",") } },
        parseAs: "arrayBuffer",
      }),
    ) as Promise<ArrayBuffer>,

  /// Null where the job has none yet.
  jobFile: async (id: string): Promise<JsonObject | null> => {
    try {
      return (await ask(client.GET("/api/jobs/{id}/job.json", { params: of(id) }))) as JsonObject;
    } catch (error) {
      if (error instanceof ApiError && error.status === 404) return null;
      throw error;
    }
  },

  putJobFile: (id: string, file: JsonObject) =>
    ask(
      client.PUT("/api/jobs/{id}/job.json", { params: of(id), body: file as Record<string, never> }),
    ) as Promise<undefined>,

  estimate: (id: string, signal: AbortSignal) =>
    ask(client.POST("/api/jobs/{id}/estimate", { params: of(id), signal })) as Promise<Estimate>,

  /// Without `how` it is packed anew, or goes on where it was interrupted.
  start: (id: string, how: Start | null = null) =>
    ask(client.POST("/api/jobs/{id}/start", { params: of(id), ...(how ? { body: how } : {}) })) as Promise<Job>,

  change: (id: string, changes: readonly Change[]) =>
    ask(
      client.POST("/api/jobs/{id}/change", { params: of(id), body: { changes: changes.map(plainChange) } }),
    ) as Promise<Job>,

  revert: (id: string, revision: number) =>
    ask(client.POST("/api/jobs/{id}/revert", { params: of(id), body: { revision } })) as Promise<Job>,

  cancel: (id: string) => ask(client.POST("/api/jobs/{id}/cancel", { params: of(id) })) as Promise<Job>,

  packing: (id: string) => ask(client.GET("/api/jobs/{id}/packing.json", { params: of(id) })) as Promise<unknown>,

  check: (id: string) => ask(client.GET("/api/jobs/{id}/check", { params: of(id) })) as Promise<unknown>,

  clearance: (id: string, tray: number, placement: number, signal: AbortSignal) =>
    ask(
      client.GET("/api/jobs/{id}/clearance", { params: { ...of(id), query: { tray, placement } }, signal }),
    ) as Promise<Clearance>,

  /// Of a copy that would stand elsewhere.
  askClearance: (id: string, copy: PlacedCopy, changes: readonly Change[], signal: AbortSignal) =>
    ask(
      client.POST("/api/jobs/{id}/clearance", {
        params: of(id),
        body: { ...plainChange(copy), transform: matrixOf(copy.transform), changes: changes.map(plainChange) },
        signal,
      }),
    ) as Promise<Clearance>,
};

export interface PlacedCopy extends Change {
  readonly transform: readonly (readonly number[])[];
}

const matrixOf = (transform: readonly (readonly number[])[]) => transform.map((row) => [...row]);

/// What the server takes, and nothing else that a copy may carry.
const plainChange = ({ tray, part, copy, transform }: Change) => ({
  tray,
  part,
  copy,
  transform: transform && matrixOf(transform),
});

/// Addresses for links and pictures.
export type ResultKind = "3mf" | "stl" | "json" | "csv" | "png" | "html";

export function resultUrl(id: string, kind: ResultKind, tray: number | null): string {
  const query = tray === null || kind === "json" ? "" : `?tray=${tray}`;
  return `./api/jobs/${id}/packing.${kind}${query}`;
}

/// A small picture of a job's build.
export const pictureUrl = (id: string): string => `./api/jobs/${id}/picture.png`;

export function fileUrl(id: string, name: string): string {
  return `./api/jobs/${id}/files/${encodeURIComponent(name)}`;
}
