/// The whole way, as an operator goes it: from files to a build that is checked, exported and found again.

import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from "vitest";
import { coloursDrawn, expectAccessible, further, launch, open, picture } from "./browser";
import { check, Server, samples } from "./server";

let browser: Browser;
let server: Server;

beforeAll(async () => {
  browser = await launch();
});
afterAll(() => browser.close());
beforeEach(async () => {
  server = new Server();
  await server.start();
});
afterEach(() => server.close());

const packButton = (page: Page) => page.getByRole("button", { name: /^Pack \d+ copies/ });
const verdict = (page: Page) => page.getByText("Comes apart: checked").first();
const jobOf = (page: Page) => /#\/job\/([a-z0-9]{12})/.exec(page.url())?.[1] ?? "";

async function sample(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Try the sample" }).click();
  await packButton(page).waitFor();
}

/// Parts that take the packer some seconds, as a script brings them.
async function longJob(page: Page): Promise<void> {
  const jobs = `${server.url}api/jobs`;
  const id = (await (await fetch(jobs, { method: "POST", body: JSON.stringify({ sample: true }) })).json()).id;
  const job = await (await fetch(`${jobs}/${id}/job.json`)).json();
  job.container = { size: [320, 240, 240] };
  job.options = { voxel: 0.6, "height-at": "top" };
  for (const part of job.parts) part.count = 40;
  await fetch(`${jobs}/${id}/job.json`, { method: "PUT", body: JSON.stringify(job) });
  await page.goto(`${server.url}#/job/${id}/parts`);
  await packButton(page).waitFor();
}

describe("from parts to the printer", () => {
  test("the sample is packed, checked and taken away", async () => {
    const { page, wrong } = await open(browser, server.url);
    await expectAccessible(page);
    await picture(page, "start");
    await sample(page);
    await expectAccessible(page);
    await picture(page, "parts");
    await packButton(page).click();
    await verdict(page).waitFor({ timeout: 60_000 });
    await page.waitForTimeout(1500);
    expect(await coloursDrawn(page)).toBeGreaterThan(30);
    await expectAccessible(page);
    await picture(page, "build");
    expect(check(server.jobFolder(jobOf(page)))).toBe(0);

    await page.getByRole("button", { name: "Export" }).click();
    await picture(page, "export");
    const download = page.waitForEvent("download");
    await page.getByRole("menuitem", { name: /3MF/ }).click();
    const taken = await (await download).path();
    expect(readFileSync(taken).subarray(0, 2).toString()).toBe("PK");
    expect(wrong).toEqual([]);
  });

  test("files are chosen, a bad one among them", async () => {
    const { page } = await open(browser, server.url);
    const names = ["bracket.stl", "gear.stl", "mug.stl"];
    const files = names.map((name) => ({ name, mimeType: "model/stl", buffer: readFileSync(join(samples, name)) }));
    const half = files[0]?.buffer.subarray(0, 900) ?? Buffer.alloc(0);
    const chooser = page.waitForEvent("filechooser");
    await page.getByRole("button", { name: "Choose files" }).click();
    await (await chooser).setFiles([
      ...files,
      { name: "half.stl", mimeType: "model/stl", buffer: half },
      { name: "cover.step", mimeType: "application/step", buffer: Buffer.from("ISO-10303-21;") },
    ]);
    await page.getByText("2 of 5 files cannot be used").waitFor();
    await expectAccessible(page);
    await picture(page, "bad-files");
    await packButton(page).click();
    await verdict(page).waitFor({ timeout: 60_000 });
    expect(check(server.jobFolder(jobOf(page)))).toBe(0);
  });

  test("a folder is dropped onto the page", async () => {
    const { page, wrong } = await open(browser, server.url);
    const folder = join(server.folder, "parts");
    mkdirSync(join(folder, "small"), { recursive: true });
    copyFileSync(join(samples, "nut.stl"), join(folder, "small", "nut.stl"));
    copyFileSync(join(samples, "ring.stl"), join(folder, "ring.stl"));
    const devtools = await page.context().newCDPSession(page);
    const data = { items: [], files: [folder], dragOperationsMask: 1 };
    for (const type of ["dragEnter", "dragOver", "drop"] as const) {
      await devtools.send("Input.dispatchDragEvent", { type, x: 500, y: 400, data });
      if (type === "dragOver") await picture(page, "dragged-over");
    }
    await packButton(page).waitFor();
    for (const name of ["nut", "ring"]) await page.getByText(name, { exact: true }).first().waitFor();
    expect(wrong).toEqual([]);
  });

  further("the section, colours and a copy are looked at in the dark", async () => {
    const { page, wrong } = await open(browser, server.url);
    await page.emulateMedia({ colorScheme: "dark" });
    await sample(page);
    await packButton(page).click();
    await verdict(page).waitFor({ timeout: 60_000 });
    const canvas = page.locator("canvas").first();
    await page.waitForTimeout(1500);
    const whole = await canvas.screenshot();
    await page.keyboard.press("z");
    await page.waitForTimeout(1500);
    const cut = await canvas.screenshot();
    expect(cut.equals(whole)).toBe(false);
    await expectAccessible(page);
    await picture(page, "section-dark");
    for (const colouring of ["Order", "Height", "Way out"]) {
      await page
        .getByRole("radio", { name: colouring })
        .or(page.getByRole("button", { name: colouring }))
        .first()
        .click();
      await page.waitForTimeout(600);
      await picture(page, `colour-${colouring.toLowerCase().replace(" ", "-")}`);
    }
    expect(wrong).toEqual([]);
  });
});

describe("while it is packed", () => {
  further("copies are seen to land, a reload catches up, and stopping keeps the best so far", async () => {
    const { page } = await open(browser, server.url);
    await longJob(page);
    await packButton(page).click();
    await page.getByText("Just placed").waitFor({ timeout: 60_000 });
    const canvas = page.locator("canvas").first();
    const first = await canvas.screenshot();
    await page.waitForTimeout(3000);
    expect((await canvas.screenshot()).equals(first)).toBe(false);
    await expectAccessible(page);
    await picture(page, "packing");
    await page.reload();
    await page.getByText("Just placed").waitFor({ timeout: 60_000 });
    expect(await coloursDrawn(page)).toBeGreaterThan(15);
    await page.getByRole("button", { name: /Stop and keep/ }).click();
    await verdict(page).waitFor({ timeout: 120_000 });
    expect(check(server.jobFolder(jobOf(page)))).toBe(0);
    await picture(page, "stopped");
  });

  further("the server is killed and begins again: the page goes on", async () => {
    const { page } = await open(browser, server.url);
    await longJob(page);
    await packButton(page).click();
    await page.getByText("Just placed").waitFor({ timeout: 60_000 });
    await server.stop("SIGKILL");
    await page.waitForTimeout(3000);
    await picture(page, "lost");
    await server.start();
    await page.getByRole("button", { name: /Stop and keep/ }).click({ timeout: 60_000 });
    await verdict(page).waitFor({ timeout: 120_000 });
  });
});

describe("jobs", () => {
  further("are found again, copied and deleted", async () => {
    const { page } = await open(browser, server.url);
    await sample(page);
    await packButton(page).click();
    await verdict(page).waitFor({ timeout: 60_000 });
    await page.goto(server.url);
    await page.getByText("Sample").first().waitFor();
    await page.waitForTimeout(1000);
    await expectAccessible(page);
    await picture(page, "jobs");
  });
});

describe("on smaller screens", () => {
  for (const [width, height] of [
    [1280, 720],
    [1024, 768],
    [820, 1180],
  ] as const) {
    further(`${width} by ${height}`, async () => {
      const { page } = await open(browser, server.url, { width, height });
      await sample(page);
      await picture(page, `parts-${width}`);
      await packButton(page).click();
      await page.getByRole("button", { name: "Export" }).waitFor({ timeout: 60_000 });
      // Where the panels are drawers, the verdict is in one of them.
      const figures = page.getByRole("button", { name: "Figures" });
      if (await figures.isVisible()) await figures.click();
      await page
        .getByText(/^(Comes apart: checked|Checked)$/)
        .and(page.locator(":visible"))
        .first()
        .waitFor({ timeout: 60_000 });
      await page.waitForTimeout(1500);
      await expectAccessible(page);
      await picture(page, `build-${width}`);
      // Panels scroll, the page never does.
      expect(await page.evaluate(() => document.documentElement.scrollHeight <= window.innerHeight + 1)).toBe(true);
    });
  }
});
