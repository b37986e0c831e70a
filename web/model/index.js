// Everything that a page without Python answers apart from numbers.

export { pythonCode, toToml } from "./code.js";
export { InputError, TooMuch } from "./check.js";
export { given, stateOf } from "./given.js";
export { asked, within } from "./request.js";
export { fromDict, fromQuery, toDict, toQuery, withValues } from "./scenario.js";
export { tables } from "./tables.js";
export { thresholds } from "./theory.js";
export { story, summary } from "./words.js";
