// What the tests need of Node.

declare module "node:assert/strict";
declare module "node:test";
