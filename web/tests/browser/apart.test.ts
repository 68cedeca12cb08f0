/// A build is taken apart again: played to its end, scrubbed, and asked what is in a copy's way.

import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from "vitest";
import { expectAccessible, further, launch, open, picture } from "./browser";
import { Server } from "./server";

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

/// The sample, packed, on its third step.
async function takenApart(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Try the sample" }).click();
  await page.getByRole("button", { name: /^Pack \d+ copies/ }).click();
  await page.getByRole("link", { name: "Take apart" }).click({ timeout: 120_000 });
  await page.getByRole("button", { name: "Play (Space)" }).waitFor();
  await page.waitForTimeout(2500);
}

/// Software draws slowly.
const patient = { timeout: 20_000 };

const timeline = (page: Page) => page.getByRole("slider", { name: "Step" });
const stepNow = async (page: Page) => Number(await timeline(page).getAttribute("aria-valuenow"));
const steps = async (page: Page) => Number(await timeline(page).getAttribute("aria-valuemax"));

/// The share of a picture that is darker than the ground of the light view.
function darkShare(page: Page, image: Buffer): Promise<number> {
  return page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    if (!context) return 0;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    let dark = 0;
    for (let i = 0; i < data.length; i += 4) if ((data[i] ?? 0) < 215) dark += 1;
    return (4 * dark) / data.length;
  }, Array.from(image));
}

/// Clicks into the tray until a copy is selected that others stand above.
async function selectBlocked(page: Page): Promise<void> {
  const box = await page.locator("canvas").first().boundingBox();
  if (!box) throw new Error("there is no picture");
  for (const [x, y] of [
    [0.5, 0.62],
    [0.45, 0.7],
    [0.55, 0.7],
    [0.4, 0.62],
    [0.6, 0.6],
  ] as const) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await page.waitForTimeout(1500);
    if ((await page.getByRole("list", { name: "In its way" }).count()) > 0) return;
  }
  throw new Error("no copy that others stand above was met");
}

describe("taking apart", () => {
  test("is played until only the empty tray is left", async () => {
    const { page, wrong } = await open(browser, server.url);
    await takenApart(page);
    const canvas = page.locator("canvas").first();
    const whole = await darkShare(page, await canvas.screenshot());
    await expectAccessible(page);
    await picture(page, "apart");
    await page.getByRole("combobox", { name: "Speed" }).selectOption("16");
    await page.getByRole("button", { name: "Play (Space)" }).click();
    await page.getByText("All copies are out.").first().waitFor({ timeout: 120_000 });
    expect(await stepNow(page)).toBe(await steps(page));
    await page.waitForTimeout(1500);
    // A few lines on a plain ground.
    expect(await darkShare(page, await canvas.screenshot())).toBeLessThan(whole / 10);
    await expectAccessible(page);
    await picture(page, "apart-end");
    expect(wrong).toEqual([]);
  });

  further("is scrubbed, and gone through by keys", async () => {
    const { page, wrong } = await open(browser, server.url);
    await takenApart(page);
    const canvas = page.locator("canvas").first();
    const whole = await canvas.screenshot();
    const last = await steps(page);
    const box = await timeline(page).boundingBox();
    if (!box) throw new Error("there is no timeline");
    await page.mouse.move(box.x + 2, box.y + 30);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y + 30, { steps: 4 });
    await page.mouse.up();
    expect(Math.abs((await stepNow(page)) - last / 2)).toBeLessThan(2);
    await page.waitForTimeout(1000);
    expect((await canvas.screenshot()).equals(whole)).toBe(false);
    await picture(page, "apart-scrubbed");

    await page.keyboard.press("Home");
    expect(await stepNow(page)).toBe(1);
    await page.keyboard.press("Shift+ArrowRight");
    expect(await stepNow(page)).toBe(11);
    await page.keyboard.press("ArrowLeft");
    await expect.poll(() => stepNow(page), patient).toBe(10);
    await page.keyboard.press("Space");
    await page.getByRole("button", { name: "Pause (Space)" }).waitFor();
    await page.keyboard.press("Space");
    await page.getByRole("button", { name: "Play (Space)" }).waitFor();
    await page.keyboard.press("End");
    await page.getByText("All copies are out.").first().waitFor();
    expect(wrong).toEqual([]);
  });

  further("says what is in a copy's way, and plays until it is out", async () => {
    const { page, wrong } = await open(browser, server.url);
    await page.emulateMedia({ colorScheme: "dark" });
    await takenApart(page);
    await selectBlocked(page);
    const blockers = page.getByRole("list", { name: "In its way" }).getByRole("listitem");
    const before = await blockers.count();
    expect(before).toBeGreaterThan(0);
    await expectAccessible(page);
    await picture(page, "apart-blockers-dark");
    // At the step at which the first of them leaves it still stands there, and not any more after it.
    await blockers.first().getByRole("button", { name: /^step/ }).click();
    expect(await blockers.count()).toBe(before);
    await page.keyboard.press("ArrowRight");
    await expect.poll(() => blockers.count(), patient).toBe(before - 1);
    await page.getByRole("combobox", { name: "Speed" }).selectOption("16");
    await page.getByRole("button", { name: "Play until it is out" }).click();
    await page.getByText(/left at/).waitFor({ timeout: 120_000 });
    expect(wrong).toEqual([]);
  });

  further("draws all of it apart", async () => {
    const { page, wrong } = await open(browser, server.url);
    await takenApart(page);
    await page.getByRole("button", { name: "All, drawn apart" }).click();
    await page.waitForTimeout(1500);
    await expectAccessible(page);
    await picture(page, "apart-drawn");
    expect(wrong).toEqual([]);
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
      await takenApart(page);
      await expectAccessible(page);
      await picture(page, `apart-${width}`);
      // Panels scroll, the page never does.
      expect(await page.evaluate(() => document.documentElement.scrollHeight <= window.innerHeight + 1)).toBe(true);
      if (width > 1000) return;
      await page.getByRole("button", { name: "This step" }).click();
      await expectAccessible(page);
      await picture(page, `apart-${width}-step`);
    });
  }
});
