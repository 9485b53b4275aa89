import { defineConfig } from "vitest/config";

// Tests run in Node; those of pages start a browser themselves (tests/browser.ts), which all files of a run share:
// they run one after the other in one process, with the same modules. Limits of time are for machines of any speed.
export default defineConfig({
  test: {
    environment: "node",
    include: ["tests/**/*.test.ts"],
    testTimeout: 300_000,
    hookTimeout: 300_000,
    expect: { poll: { timeout: 120_000 } },
    pool: "forks",
    poolOptions: { forks: { singleFork: true, isolate: false } },
  },
});
