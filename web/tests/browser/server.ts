/// Starts the real server on a folder of its own.

import { type ChildProcess, spawn, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const build = process.env.SPECTRALPACK_BUILD ?? resolve("../build");
export const program = join(build, "apps/cli/spectralpack");
export const samples = resolve("../data/samples");

async function freePort(): Promise<number> {
  return new Promise((done) => {
    const probe = createServer().listen(0, "127.0.0.1", () => {
      const address = probe.address();
      probe.close(() => done(typeof address === "object" && address ? address.port : 0));
    });
  });
}

export class Server {
  readonly folder = mkdtempSync(join(tmpdir(), "spectralpack-page-"));
  url = "";
  private process: ChildProcess | null = null;
  private port = 0;

  async start(...options: string[]): Promise<void> {
    if (this.port === 0) this.port = await freePort();
    const words = ["serve", "--dir", join(this.folder, "jobs"), "--port", `${this.port}`, "--no-browser", ...options];
    const started = spawn(program, words, { stdio: ["ignore", "pipe", "inherit"] });
    this.process = started;
    await new Promise<void>((done, failed) => {
      started.stdout?.once("data", () => done());
      started.once("exit", (status) => failed(new Error(`the server ended with ${status}`)));
    });
    this.url = `http://127.0.0.1:${this.port}/`;
  }

  async stop(how: NodeJS.Signals = "SIGINT"): Promise<void> {
    const process = this.process;
    if (!process) return;
    this.process = null;
    await new Promise((done) => {
      process.once("exit", done);
      process.kill(how);
    });
  }

  async close(): Promise<void> {
    await this.stop();
    rmSync(this.folder, { recursive: true, force: true });
  }

  jobFolder(id: string): string {
    return join(this.folder, "jobs", id);
  }
}

/// The exit status of the program's own check of a job's packing.
export function check(folder: string): number | null {
  return spawnSync(program, ["check", "--require-plan", join(folder, "packing.json")]).status;
}
