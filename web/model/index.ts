// Everything that a page without Python answers apart from numbers.

export { InputError } from "./check.ts";
export * from "./cells.ts";
export * from "./files.ts";
export * from "./given.ts";
export * from "./header.ts";
export * from "./request.ts";
export * from "./scenario.ts";
export * from "./theory.ts";
export * from "./words.ts";
