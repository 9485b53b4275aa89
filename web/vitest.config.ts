import { defineConfig } from "vitest/config";

// Tests run in Node; those of pages start a browser themselves (tests/browser.ts).
export default defineConfig({
  test: {
    environment: "node",
    include: ["tests/**/*.test.ts"],
    testTimeout: 120_000,
    hookTimeout: 120_000,
    // Two browsers at a time are enough for a small machine.
    maxWorkers: 2,
    minWorkers: 1,
  },
});
