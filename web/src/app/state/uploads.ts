/// Files on their way to the server, three at a time.

import { ApiError } from "../../api/client";
import { putFile, type Upload } from "../../api/upload";
import type { NamedFile, RefusedFile } from "./file_names";
import { Store } from "./store";

export interface UploadState {
  readonly total: number;
  readonly done: number;
  readonly bytes: number;
  readonly sent: number;
  readonly active: boolean;
}

const idle: UploadState = { total: 0, done: 0, bytes: 0, sent: 0, active: false };
const together = 3;

export class Uploads {
  readonly state = new Store<UploadState>(idle);
  private readonly waiting: NamedFile[] = [];
  private readonly running = new Map<NamedFile, { upload: Upload; sent: number }>();
  private doneBytes = 0;

  constructor(
    private readonly job: string,
    /// A file is on the server, or was refused.
    private readonly told: (name: string, refused: RefusedFile | null) => void,
  ) {}

  add(files: readonly NamedFile[]): void {
    if (files.length === 0) return;
    this.waiting.push(...files);
    const { total, bytes } = this.state.value;
    const more = files.reduce((sum, { file }) => sum + file.size, 0);
    this.state.set({ total: total + files.length, bytes: bytes + more, active: true });
    this.next();
  }

  /// What is on the server stays there.
  stop(): void {
    this.waiting.length = 0;
    for (const { upload } of this.running.values()) upload.stop();
    this.finishIfIdle();
  }

  private next(): void {
    while (this.running.size < together) {
      const file = this.waiting.shift();
      if (!file) break;
      this.send(file);
    }
    this.finishIfIdle();
  }

  private send(file: NamedFile): void {
    const entry = {
      sent: 0,
      upload: putFile(this.job, file.name, file.file, (sent) => {
        entry.sent = sent;
        this.count();
      }),
    };
    this.running.set(file, entry);
    entry.upload.done
      .then(() => this.told(file.name, null))
      .catch((error: unknown) => {
        if (error instanceof ApiError) this.told(file.name, { file: file.name, error: error.message });
      })
      .finally(() => {
        this.running.delete(file);
        this.doneBytes += file.file.size;
        this.state.set({ done: this.state.value.done + 1 });
        this.count();
        this.next();
      });
  }

  private count(): void {
    let sent = this.doneBytes;
    for (const entry of this.running.values()) sent += entry.sent;
    this.state.set({ sent });
  }

  private finishIfIdle(): void {
    if (this.running.size > 0 || this.waiting.length > 0) return;
    this.doneBytes = 0;
    this.state.set(idle);
  }
}
