/// A build that is changed by hand, packed again round what is locked, and made better: with the real server, which has
/// the last word on every gap.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from "vitest";
import { expectAccessible, further, launch, open, picture } from "./browser";
import { check, Server } from "./server";

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

interface Copy {
  readonly part: number;
  readonly copy: number;
  readonly transform: readonly (readonly number[])[];
}

interface PackingFile {
  readonly parts: readonly { readonly name: string }[];
  readonly trays: readonly { readonly placements: readonly Copy[] }[];
}

const verdict = (page: Page) => page.getByText("Comes apart: checked").first();
const jobOf = (page: Page) => /#\/job\/([a-z0-9]{12})/.exec(page.url())?.[1] ?? "";
const folderOf = (page: Page) => server.jobFolder(jobOf(page));
const undo = (page: Page) => page.getByRole("button", { name: "Undo (Ctrl+Z)" });

function packingOf(page: Page): PackingFile {
  return JSON.parse(readFileSync(join(folderOf(page), "packing.json"), "utf8"));
}

function placed(page: Page): readonly Copy[] {
  return packingOf(page).trays[0]?.placements ?? [];
}

function find(page: Page, { part, copy }: { part: number; copy: number }): Copy | undefined {
  return placed(page).find((own) => own.part === part && own.copy === copy);
}

async function sampleBuild(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Try the sample" }).click();
  await page.getByRole("button", { name: /^Pack \d+ copies/ }).click();
  await verdict(page).waitFor({ timeout: 60_000 });
}

/// Its row selects all copies of a part; then one of them.
async function select(page: Page, part: string): Promise<void> {
  await page.getByRole("button", { name: new RegExp(`^Select ${part},`) }).click();
  await page.getByRole("button", { name: "One after the other" }).click();
}

async function findCopy(page: Page, name: string): Promise<void> {
  await page.keyboard.press("/");
  await page.locator("sp-find input").fill(name);
  await page.keyboard.press("Enter");
}

/// Until the server has checked what was changed.
async function checked(page: Page, change: () => Promise<void>): Promise<void> {
  const before = JSON.stringify(placed(page));
  await change();
  await expect.poll(() => JSON.stringify(placed(page)) !== before, { timeout: 30_000 }).toBe(true);
  await verdict(page).waitFor({ timeout: 60_000 });
}

describe("a build", () => {
  further("loses a copy, which is put back by undo", async () => {
    const { page, wrong } = await open(browser, server.url);
    await sampleBuild(page);
    const before = placed(page);
    await select(page, "gear");
    await checked(page, async () => {
      await page.keyboard.press("Delete");
      await page.getByText("Taken out by hand.").waitFor();
      await page.getByRole("button", { name: "Put back" }).waitFor();
      await picture(page, "removed");
    });
    expect(placed(page)).toHaveLength(before.length - 1);
    expect(check(folderOf(page))).toBe(0);
    await expectAccessible(page);
    await checked(page, () => undo(page).click());
    expect(placed(page)).toHaveLength(before.length);
    expect(await page.getByText("Taken out by hand.").count()).toBe(0);
    await checked(page, () => page.keyboard.press("Control+Shift+Z"));
    await checked(page, () => page.getByRole("button", { name: "Put back" }).click());
    expect(placed(page)).toHaveLength(before.length);
    expect(check(folderOf(page))).toBe(0);
    expect(wrong).toEqual([]);
  });

  test("has a copy moved by keys: not into another, but to a free place", async () => {
    const { page, wrong } = await open(browser, server.url);
    await sampleBuild(page);
    const part = packingOf(page).parts.findIndex(({ name }) => name === "hinge");
    // The one that stands highest has room above it.
    const high = ({ transform }: Copy) => transform[2]?.[3] ?? 0;
    const own = placed(page).filter((copy) => copy.part === part);
    const top = own.reduce((best, copy) => (high(copy) > high(best) ? copy : best));
    await findCopy(page, `hinge ${top.copy + 1}`);
    await page.keyboard.press("m");
    await page.getByText("you move").waitFor();
    await page.getByText("It may stand here.").waitFor();
    await page.keyboard.press("Shift+PageDown");
    await page
      .locator("sp-move .note.bad")
      .getByText(/is asked for\.|sticks out/)
      .waitFor();
    expect(await page.getByRole("button", { name: "Place here" }).isDisabled()).toBe(true);
    expect(await page.getByRole("button", { name: /^Export/ }).isDisabled()).toBe(true);
    await expectAccessible(page);
    await picture(page, "move-clash");
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: /nearest free place/ }).click();
    await page.getByText("It may stand here.").waitFor({ timeout: 30_000 });
    await page.getByRole("button", { name: "Put back" }).click();
    await page.getByText("you move").waitFor({ state: "detached" });

    const before = placed(page).filter((own) => own.part === part);
    await page.keyboard.press("m");
    await page.getByText("It may stand here.").waitFor();
    await page.keyboard.press("PageUp");
    await page.keyboard.press("PageUp");
    await page.getByText("+2.0").waitFor();
    await checked(page, async () => {
      await page.getByText("It may stand here.").waitFor();
      await page.keyboard.press("Enter");
    });
    const after = placed(page).filter((own) => own.part === part);
    const heights = (own: readonly Copy[]) =>
      own.map(({ copy, transform }) => `${copy} ${transform[2]?.[3]?.toFixed(3)}`);
    expect(heights(after).filter((height) => !heights(before).includes(height))).toHaveLength(1);
    expect(check(folderOf(page))).toBe(0);
    await checked(page, () => page.keyboard.press("Control+z"));
    expect(heights(placed(page).filter((own) => own.part === part)).sort()).toEqual(heights(before).sort());
    expect(wrong).toEqual([]);
  });

  test("keeps what is locked while the rest is packed again, and goes back", async () => {
    const { page, wrong } = await open(browser, server.url);
    await sampleBuild(page);
    const names = ["mug", "box"];
    const locked = names.map((name) => {
      const part = packingOf(page).parts.findIndex((own) => own.name === name);
      return placed(page).find((own) => own.part === part) as Copy;
    });
    for (const [i, name] of names.entries()) {
      await findCopy(page, `${name} ${(locked[i]?.copy ?? 0) + 1}`);
      await page.keyboard.press("l");
      await page.getByRole("button", { name: "Locked" }).waitFor();
    }
    await page.keyboard.press("Escape");
    await picture(page, "locked");
    await expectAccessible(page);
    const before = placed(page);
    await page.keyboard.press("Control+Enter");
    await picture(page, "pack-again");
    await page.getByRole("menuitem", { name: /^Keep locked copies \(2\)/ }).click();
    await page.getByRole("button", { name: /^Export/ }).waitFor({ state: "detached" });
    await verdict(page).waitFor({ timeout: 60_000 });
    for (const copy of locked) expect(find(page, copy)?.transform).toEqual(copy.transform);
    expect(placed(page)).toHaveLength(before.length);
    expect(check(folderOf(page))).toBe(0);
    // The locks are still there, also after a reload.
    await page.reload();
    await page.getByTitle("1 locked").first().waitFor();
    expect(await page.getByTitle("1 locked").count()).toBe(2);
    expect(wrong).toEqual([]);
  });

  further("is packed again, and undo goes back to the one before", async () => {
    const { page } = await open(browser, server.url);
    await sampleBuild(page);
    await select(page, "nut");
    await checked(page, () => page.keyboard.press("Delete"));
    const before = placed(page);
    await page.keyboard.press("Control+Enter");
    await page.getByRole("menuitem", { name: /^Keep all, add what is missing/ }).click();
    await page.getByRole("button", { name: /^Export/ }).waitFor({ state: "detached" });
    await verdict(page).waitFor({ timeout: 60_000 });
    expect(placed(page)).toHaveLength(before.length + 1);
    for (const copy of before) expect(find(page, copy)?.transform).toEqual(copy.transform);
    await checked(page, () => undo(page).click());
    expect(placed(page)).toHaveLength(before.length);
    expect(check(folderOf(page))).toBe(0);
  });
});

describe("improving", () => {
  test("shows its curve, also after a reload, and stops with the best", async () => {
    const { page, wrong } = await open(browser, server.url);
    await sampleBuild(page);
    const height = async () => Number(/([\d.]+)/.exec((await page.locator(".fig").first().textContent()) ?? "")?.[1]);
    await page.getByRole("button", { name: "Keep improving" }).click();
    await expectAccessible(page);
    await page.getByRole("menuitem", { name: "For 5 minutes" }).click();
    await page.getByRole("img", { name: /^height from/ }).waitFor({ timeout: 60_000 });
    await page.waitForTimeout(6000);
    await expectAccessible(page);
    await picture(page, "improving");
    await page.reload();
    await page.getByRole("img", { name: /^height from/ }).waitFor({ timeout: 60_000 });
    expect(await height()).toBeGreaterThan(0);
    await page.getByRole("button", { name: "Stop and keep the best" }).click();
    await verdict(page).waitFor({ timeout: 120_000 });
    await page.getByText(/^(Made better:|Nothing better)/).waitFor();
    await picture(page, "improved");
    await expectAccessible(page);
    expect(check(folderOf(page))).toBe(0);
    expect(wrong).toEqual([]);
  });
});
