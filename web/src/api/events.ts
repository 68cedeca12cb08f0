/// A job as it runs: server-sent events. The browser asks again by itself after a lost connection, from where it was; where
/// the server refuses, we do.

import type { Job } from "./types";

export interface JobEvents {
  state(job: Job): void;
  line(line: unknown): void;
  /// The lines before belong to an earlier run, or are told again.
  anew(): void;
  connected(there: boolean): void;
}

const again = 3000;

export function watchJob(id: string, events: JobEvents): () => void {
  let source: EventSource | null = null;
  let timer = 0;

  const begin = () => {
    source = new EventSource(`./api/jobs/${id}/events`);
    const on = (name: string, tell: (data: unknown) => void) =>
      source?.addEventListener(name, (event) => {
        try {
          tell(JSON.parse((event as MessageEvent<string>).data));
        } catch {
          // A torn line says nothing; what follows it still counts.
        }
      });
    on("state", (data) => events.state(data as Job));
    on("line", (data) => events.line(data));
    on("anew", () => events.anew());
    source.onopen = () => events.connected(true);
    source.onerror = () => {
      events.connected(false);
      if (source?.readyState !== EventSource.CLOSED) return;
      timer = window.setTimeout(() => {
        events.anew();
        begin();
      }, again);
    };
  };

  begin();
  return () => {
    clearTimeout(timer);
    source?.close();
  };
}
