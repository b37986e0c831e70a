// Everything that a page without Python answers apart from numbers.

export { cellsOf, mapReply, spanOf } from "./cells.ts";
export { pythonCode, toToml } from "./code.ts";
export { InputError, TooMuch } from "./check.ts";
export { resultText, tableText, timesOf } from "./files.ts";
export { given, stateOf } from "./given.ts";
export { headerOf, resultOf } from "./header.ts";
export { readable } from "./link.ts";
export { doubtText, labText, within, withinMap } from "./limits.ts";
export { asked, requested } from "./request.ts";
export { fromDict, fromQuery, toDict, toQuery, withValues } from "./scenario.ts";
export { tables } from "./tables.ts";
export { thresholds } from "./theory.ts";
export { halfway, stills, story, summary } from "./words.ts";
