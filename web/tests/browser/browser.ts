/// A real Chromium with software drawing, pictures of what it shows, and what must hold on every view.

import { existsSync, mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { AxeBuilder } from "@axe-core/playwright";
import { type Browser, chromium, type Page } from "playwright-core";
import { expect, test } from "vitest";

const paths = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome"];
/// Tests that go ways beside the main ones; PAGE_TESTS=short leaves them out.
export const further = test.skipIf(process.env.PAGE_TESTS === "short");

const pictures = process.env.PICTURES ?? resolve("../out/page");

export async function launch(): Promise<Browser> {
  const executablePath = paths.find((path) => path && existsSync(path));
  if (!executablePath) throw new Error("no Chromium here");
  return chromium.launch({ executablePath, args: ["--enable-unsafe-swiftshader", "--no-sandbox"] });
}

/// A page that remembers what went wrong in it: errors, refused scripts or styles, requests to elsewhere.
export async function open(browser: Browser, url: string, size = { width: 1440, height: 900 }): Promise<Opened> {
  const context = await browser.newContext({ viewport: size, acceptDownloads: true });
  const page = await context.newPage();
  const wrong: string[] = [];
  page.on("pageerror", (error) => wrong.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" && !message.text().includes("favicon")) wrong.push(message.text());
  });
  page.on("request", (request) => {
    if (!request.url().startsWith(url) && !/^(blob|data):/.test(request.url())) wrong.push(`asks ${request.url()}`);
  });
  await page.goto(url);
  return { page, wrong };
}

export interface Opened {
  readonly page: Page;
  readonly wrong: string[];
}

export async function picture(page: Page, name: string): Promise<void> {
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`) });
}

/// Without motion: a button that turns from one state into another has the colours of neither for a moment.
export async function expectAccessible(page: Page): Promise<void> {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const { violations } = await new AxeBuilder({ page }).analyze();
  await page.emulateMedia({ reducedMotion: null });
  const said = violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join(", ")}`);
  expect(said).toEqual([]);
}

/// How many different colours the page's largest drawing shows: one or two are a blank one.
export async function coloursDrawn(page: Page): Promise<number> {
  const box = await page.locator("canvas").first().boundingBox();
  if (!box) return 0;
  const image = await page.screenshot({ clip: box });
  return page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext("2d");
    if (!context) return 0;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const colours = new Set<number>();
    for (let i = 0; i < data.length; i += 4) {
      colours.add((((data[i] ?? 0) >> 4) << 8) | (((data[i + 1] ?? 0) >> 4) << 4) | ((data[i + 2] ?? 0) >> 4));
    }
    return colours.size;
  }, Array.from(image));
}
