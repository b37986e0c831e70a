// Everything that a page without Python answers apart from numbers.

export { cellsOf, mapReply, spanOf } from "./cells.js";
export { pythonCode, toToml } from "./code.js";
export { InputError, TooMuch } from "./check.js";
export { resultText, tableText, timesOf } from "./files.js";
export { given, stateOf } from "./given.js";
export { headerOf, resultOf } from "./header.js";
export { doubtText, labText, within, withinMap } from "./limits.js";
export { ratesOf } from "./rates.js";
export { asked, mapAsked } from "./request.js";
export { fromDict, fromQuery, toDict, toQuery, withValues } from "./scenario.js";
export { tables } from "./tables.js";
export { thresholds } from "./theory.js";
export { halfway, stills, story, summary } from "./words.js";
