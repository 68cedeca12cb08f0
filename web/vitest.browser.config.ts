import { defineConfig } from "vitest/config";

// The page in a real browser, with the real server behind it (scripts/check_web.sh --browser BUILD).
export default defineConfig({
  test: { include: ["tests/browser/**/*.test.ts"], testTimeout: 240_000, hookTimeout: 60_000, fileParallelism: false },
});
