// Share and save: link, downloads, picture, film recorded here, and the Python that makes the same motion.

import { closing, copying, h, menuItem, saveBlob } from "../common/dom.ts";
import { icon } from "../common/icons.ts";
import { record, png, svg } from "../player/pictures.ts";
import type { Lab } from "./lab.ts";

/** What is kept, and who makes it. */
type Kept = Parameters<typeof record>[0] & Pick<Lab, "backend" | "film" | "link">;

const FILES = [
  ["motion.toml", "save.scenario"],
  ["motion.csv", "save.states"],
  ["motion.json", "save.events"],
];

export class Share {
  menu = h(
    "details.menu.share",
    h("summary.button", { "aria-label": "save.menu" }, h("span.long", "save.menu"), h("span.short", icon("share"))),
    h(
      "div.menu-body",
      this.lab.backend.base !== null && [
        this.item("save.copy_link", () => this.copyLink([])),
        this.item("save.copy_link_fingerprint", () => this.copyLink(this.fingerprints()), "full"),
      ],
      FILES.map(([name, label]) => this.item(label, () => this.download(name))),
      this.item("save.picture_png", () => this.picture("png", png)),
      this.item("save.picture_svg", () => this.picture("svg", svg)),
      this.item("save.record", () => this.record()),
      this.item("save.code", () => this.code()),
      h("p.full", "save.netcdf"),
    ),
  );
  dialog = h("dialog.code-dialog", { "aria-label": "save.code_title" });

  constructor(readonly lab: Kept) {}

  /** `kind`: `full` where the simple view leaves it out. */
  item(label: string, action: () => Promise<void>, kind = "") {
    return menuItem(label, () => action().catch((error) => this.lab.notice.fail(error)), kind);
  }

  fingerprints() {
    return this.lab.films().map(({ fingerprint }) => fingerprint);
  }

  async copyLink(fingerprints: string[]) {
    const link = `${this.lab.backend.base}${this.lab.link(fingerprints)}`;
    try {
      await navigator.clipboard.writeText(link);
      this.lab.notice.say(link.startsWith("file:") ? "save.link_copied_file" : "save.link_copied");
    } catch {
      this.show({ "save.link_title": link });
    }
  }

  async download(name: string) {
    const film = this.lab.film();
    saveBlob(await this.lab.backend.file(name, film.query), `hophoop-${name}`);
    this.lab.notice.say({ key: "save.ready", values: { name } });
  }

  async picture(kind: string, make: (lab: Kept) => Promise<Blob> | Blob) {
    saveBlob(await make(this.lab), `hophoop.${kind}`);
  }

  async record() {
    const film = await record(this.lab);
    saveBlob(film, film.type.startsWith("video/mp4") ? "hophoop.mp4" : "hophoop.webm");
    this.lab.notice.say("save.film_ready");
  }

  async code() {
    const { python, toml } = this.lab.backend.code(this.lab.film().scenario);
    this.show({ "save.code_title": python, "save.scenario_title": toml });
  }

  /** Texts by their headings. */
  show(texts: Named<string>) {
    const blocks = Object.entries(texts).flatMap(([title, text]) => {
      const code = h("code", document.createTextNode(text));
      return [h("header", h("h2", title), copying(code)), h("pre", { tabindex: "0" }, code)];
    });
    this.dialog.replaceChildren(...blocks, closing());
    this.dialog.showModal();
  }
}
