/// Measures what users of the page wait for, and writes it to bench/results/page.csv:
///
///     cd web && node bench/page.mjs ../build PIECES.json LARGE.json PARTS/
///
/// PIECES and LARGE are packing files to look at, PARTS a folder of at least 100 meshes. The browser is Chromium with
/// software drawing. Each figure is the median of its runs.

import { spawn } from "node:child_process";
import {
  createReadStream,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  truncateSync,
  writeFileSync,
} from "node:fs";
import { request } from "node:http";
import { cpus, tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [build, pieces, large, parts] = process.argv.slice(2);
const program = resolve(build, "apps/cli/spectralpack");
const rows = [];
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const round = (value) => Number(value.toPrecision(3));

function note(what, values, unit) {
  rows.push([what, round(median(values)), unit, values.length]);
  console.log(`${what}: ${round(median(values))} ${unit} (${values.map(round).join(", ")})`);
}

let port = 7990;
async function serve(command, folder) {
  port += 1;
  const started = performance.now();
  const child = spawn(program, [...command, "--dir", folder, "--port", `${port}`, "--no-browser"], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  const said = await new Promise((done) => child.stdout.once("data", (text) => done(`${text}`)));
  const url = /http:\S+/.exec(said)[0];
  const stop = () => new Promise((done) => child.once("exit", done) && child.kill("SIGINT"));
  return { child, url, started, stop, api: new URL("/api/jobs", url).href };
}

const folder = () => mkdtempSync(join(tmpdir(), "spectralpack-bench-"));
const memory = (pid, key) => {
  const found = new RegExp(`${key}:\\s+(\\d+)`).exec(readFileSync(`/proc/${pid}/status`, "utf8"));
  return Number(found[1]) / 1024;
};
const launch = () =>
  chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--enable-unsafe-swiftshader", "--no-sandbox", "--enable-precise-memory-info"],
  });

/// Of the browser and all its processes, MB: proportional, so that what they share counts once.
function browserMemory(root) {
  const children = new Map();
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const parent = Number(/PPid:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]);
      children.set(parent, [...(children.get(parent) ?? []), Number(pid)]);
    } catch {}
  }
  const all = [root];
  for (let i = 0; i < all.length; i += 1) all.push(...(children.get(all[i]) ?? []));
  let sum = 0;
  for (const pid of all) {
    try {
      sum += Number(/Pss:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/smaps_rollup`, "utf8"))[1]) / 1024;
    } catch {}
  }
  return sum;
}

async function firstPaint() {
  const browser = await launch();
  const times = [];
  for (let run = 0; run < 5; run += 1) {
    const jobs = folder();
    const page = await (await browser.newContext()).newPage();
    const server = await serve(["serve"], jobs);
    await page.goto(server.url, { waitUntil: "commit" });
    await page.locator("sp-drop").waitFor();
    times.push((performance.now() - server.started) / 1000);
    await page.context().close();
    await server.stop();
    rmSync(jobs, { recursive: true });
  }
  note("from serve to the page", times, "s");
  await browser.close();
}

async function hundredFiles() {
  const names = readdirSync(parts)
    .filter((name) => name.endsWith(".stl"))
    .slice(0, 100);
  const browser = await launch();
  const times = [];
  for (let run = 0; run < 3; run += 1) {
    const jobs = folder();
    const server = await serve(["serve"], jobs);
    const page = await (await browser.newContext()).newPage();
    await page.goto(server.url);
    const chooser = page.waitForEvent("filechooser");
    await page.getByRole("button", { name: "Choose files" }).click();
    const began = performance.now();
    await (await chooser).setFiles(names.map((name) => join(parts, name)));
    await page.getByRole("button", { name: /^Pack 100 copies/ }).waitFor({ timeout: 120_000 });
    times.push((performance.now() - began) / 1000);
    await page.context().close();
    await server.stop();
    rmSync(jobs, { recursive: true });
  }
  note("from 100 files to the table", times, "s");
  await browser.close();
}

/// Times at which each placed copy comes over the connection.
function watch(url, id, until) {
  const seen = [];
  return new Promise((done, failed) => {
    const asked = request(`${url}/${id}/events`, (answer) => {
      let rest = "";
      answer.on("data", (data) => {
        rest += data;
        const lines = rest.split("\n");
        rest = lines.pop();
        for (const line of lines) {
          if (line.includes('"copy_placed"')) seen.push(performance.now());
          if (line.startsWith("data:") && until(line)) {
            asked.destroy();
            done(seen);
          }
        }
      });
    });
    asked.on("error", (error) => (error.code === "ECONNRESET" ? done(seen) : failed(error)));
    asked.end();
  });
}

/// From the moment that the run has written a record until each of eight watchers has it.
async function live() {
  const jobs = folder();
  const server = await serve(["serve"], jobs);
  const id = (await (await fetch(server.api, { method: "POST", body: '{"sample": true}' })).json()).id;
  const job = await (await fetch(`${server.api}/${id}/job.json`)).json();
  job.options = { voxel: 1 };
  job.container = { size: [320, 240, 240] };
  for (const part of job.parts) part.count = 20;
  await fetch(`${server.api}/${id}/job.json`, { method: "PUT", body: JSON.stringify(job) });
  await fetch(`${server.api}/${id}/start`, { method: "POST" });
  const written = [];
  const file = join(jobs, id, "run", "events.jsonl");
  let bytes = 0;
  let copies = 0;
  const timer = setInterval(() => {
    try {
      const size = statSync(file).size;
      if (size === bytes) return;
      bytes = size;
      const now = readFileSync(file, "utf8").split("copy_placed").length - 1;
      for (; copies < now; copies += 1) written.push(performance.now());
    } catch {}
  }, 5);
  const ended = (line) => /"status":"(done|failed|cancelled)"/.test(line);
  const watchers = await Promise.all(Array.from({ length: 8 }, () => watch(server.api, id, ended)));
  clearInterval(timer);
  const late = watchers.flatMap((seen) => seen.map((time, i) => time - (written[i] ?? time)));
  const complete = watchers.every((seen) => seen.length === watchers[0].length);
  if (!complete) throw new Error("some watchers missed copies");
  note(`live view: from the record to each of eight watchers, of ${watchers[0].length} copies`, [median(late)], "ms");
  note("live view: the latest of them", [Math.max(...late)], "ms");
  await server.stop();
  rmSync(jobs, { recursive: true });
}

async function thousandJobs() {
  const jobs = folder();
  const server = await serve(["serve"], jobs);
  const before = memory(server.child.pid, "VmRSS");
  for (let i = 0; i < 1000; i += 1) await fetch(server.api, { method: "POST", body: `{"name": "job ${i}"}` });
  note("the server's memory with 1,000 jobs", [memory(server.child.pid, "VmRSS")], "MB");
  note("the same without jobs", [before], "MB");
  const listed = [];
  for (let run = 0; run < 5; run += 1) {
    const began = performance.now();
    await (await fetch(`${server.api}?most=50`)).json();
    listed.push(performance.now() - began);
  }
  note("a list of 50 of 1,000 jobs", listed, "ms");
  const times = [];
  for (let run = 0; run < 5; run += 1) {
    const began = performance.now();
    const answers = await Promise.all(Array.from({ length: 200 }, () => fetch(`${server.api}?most=50`)));
    await Promise.all(answers.map((answer) => answer.json()));
    if (!answers.every((answer) => answer.ok)) throw new Error("a request was refused");
    times.push(performance.now() - began);
  }
  note("200 requests at once, each a list of 50", times, "ms");
  await server.stop();
  rmSync(jobs, { recursive: true });
}

async function twoGigabytes() {
  const jobs = folder();
  const file = join(jobs, "large.stl");
  writeFileSync(file, "");
  truncateSync(file, 2 ** 31);
  const server = await serve(["serve"], join(jobs, "jobs"));
  const id = (await (await fetch(server.api, { method: "POST" })).json()).id;
  const began = performance.now();
  await new Promise((done, failed) => {
    const put = request(`${server.api}/${id}/files/large.stl`, {
      method: "PUT",
      headers: { "Content-Length": 2 ** 31 },
    });
    put.on("response", (answer) => {
      answer.resume();
      if (answer.statusCode === 201) done();
      else failed(new Error(`${answer.statusCode}`));
    });
    put.on("error", failed);
    createReadStream(file).pipe(put);
  });
  note("a file of 2 GiB is sent", [(performance.now() - began) / 1000], "s");
  note("the server's memory meanwhile, at most", [memory(server.child.pid, "VmHWM")], "MB");
  await server.stop();
  rmSync(jobs, { recursive: true });
}

/// Opens a build: until its copies are drawn, then frames a second while it turns, and the browser's memory.
async function look(what, packing, runs) {
  const first = [];
  const frames = [];
  const used = [];
  for (let run = 0; run < runs; run += 1) {
    const jobs = folder();
    const server = await serve(["view", packing], jobs);
    const browser = await launch();
    const page = await (await browser.newContext({ viewport: { width: 1440, height: 900 } })).newPage();
    // What is found of it beforehand (the meshes to look at) was made when the build was opened.
    const listed = async () => (await (await fetch(server.api)).json()).jobs[0];
    while (["new", "queued", "running"].includes((await listed()).status)) {
      await new Promise((done) => setTimeout(done, 200));
    }
    const job = await listed();
    const began = performance.now();
    await page.goto(`${new URL("/", server.url)}#/job/${job.id}/build`);
    await page.waitForFunction(() => performance.getEntriesByName("copies drawn").length > 0, null, {
      timeout: 120_000,
    });
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    first.push((performance.now() - began) / 1000);
    await page.waitForTimeout(4000);
    const box = await page.locator("canvas").first().boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    const count = page.evaluate(
      () =>
        new Promise((done) => {
          let drawn = 0;
          const end = performance.now() + 4000;
          const step = () => {
            drawn += 1;
            if (performance.now() < end) requestAnimationFrame(step);
            else done(drawn / 4);
          };
          requestAnimationFrame(step);
        }),
    );
    for (let i = 0; i < 40; i += 1) {
      await page.mouse.move(box.x + box.width / 2 + i * 5, box.y + box.height / 2);
      await page.waitForTimeout(80);
    }
    frames.push(await count);
    await page.mouse.up();
    used.push(browserMemory(Number(readdirSync("/proc").find((pid) => /^\d+$/.test(pid) && isBrowser(pid)))));
    await browser.close();
    await server.stop();
    rmSync(jobs, { recursive: true });
  }
  note(`${what}: first picture`, first, "s");
  note(`${what}: frames a second while it turns, drawn in software`, frames, "1/s");
  note(`${what}: the browser's memory, all its processes`, used, "MB");
}

function isBrowser(pid) {
  try {
    const words = readFileSync(`/proc/${pid}/cmdline`, "utf8").split("\0");
    return words[0].includes("chromium") && !words.some((word) => word.startsWith("--type="));
  } catch {
    return false;
  }
}

const copiesIn = (packing) => JSON.parse(readFileSync(packing, "utf8")).metrics.placed.toLocaleString("en");
await firstPaint();
await hundredFiles();
await live();
await thousandJobs();
await twoGigabytes();
for (const packing of [pieces, large]) await look(`${copiesIn(packing)} copies`, resolve(packing), 3);

const commit = await new Promise((done) => {
  const git = spawn("git", ["rev-parse", "--short", "HEAD"]);
  git.stdout.once("data", (text) => done(`${text}`.trim()));
});
const table = [
  "what,median,unit,runs",
  ...rows.map((row) => row.map((cell) => (/,/.test(cell) ? `"${cell}"` : cell)).join(",")),
];
table.push(
  `# node bench/page.mjs; commit ${commit}; ${cpus().length} cores of ${cpus()[0].model}; Chromium with software drawing`,
);
writeFileSync("../bench/results/page.csv", `${table.join("\n")}\n`);
