// The languages of the page besides English. A new one needs its table in this folder and its name here.

import de from "./de.json" with { type: "json" };
import es from "./es.json" with { type: "json" };
import fr from "./fr.json" with { type: "json" };
import zh from "./zh.json" with { type: "json" };

export default { de, es, fr, zh } as Record<string, Record<string, string>>;
