// Share and save: link, downloads, picture, film recorded here, and the Python that makes the same motion.

import { h, saveBlob, say } from "../common/dom.ts";
import { record } from "../player/recording.ts";
import { png, svg } from "../player/pictures.ts";
import type { Lab } from "./lab.ts";

/** What is kept, and who makes it. */
type Kept = Parameters<typeof record>[0] & Pick<Lab, "backend" | "film" | "link">;

const FILES = [
  ["motion.toml", "Save the scenario (TOML)"],
  ["motion.csv", "Save the states (CSV)"],
  ["motion.nc", "Save the motion (netCDF)"],
  ["motion.json", "Save the events (JSON)"],
  ["motion.mp4", "Save a film (MP4)"],
];

export class Share {
  menu: HTMLDetailsElement;
  dialog: HTMLDialogElement;

  constructor(readonly lab: Kept) {
    this.menu = h(
      "details",
      { class: "menu" },
      h(
        "summary",
        { class: "button" },
        h("span", { class: "long" }, "Share and save"),
        h("span", { class: "short" }, "Share"),
      ),
      h(
        "div",
        { class: "menu-body" },
        lab.backend.shares && this.item("Copy a link to this motion", () => this.copyLink()),
        FILES.filter(([name]) => lab.backend.files.includes(name)).map(([name, label]) =>
          this.item(label, () => this.download(name)),
        ),
        this.item("Save a picture (PNG)", () => this.picture("png", png)),
        this.item("Save a picture (SVG)", () => this.picture("svg", svg)),
        this.item("Record one run as a film (WebM)", () => this.record()),
        this.item("Show the Python code", () => this.code()),
      ),
    );
    this.dialog = h("dialog", { class: "code-dialog", "aria-label": "The same motion in Python" });
  }

  item(label: string, action: () => void) {
    return h(
      "button",
      {
        type: "button",
        onclick: async () => {
          this.menu.open = false;
          try {
            await action();
          } catch (error) {
            this.lab.notice.fail(error as Error);
          }
        },
      },
      label,
    );
  }

  async copyLink() {
    const link = this.lab.link(this.lab.films().map(({ fingerprint }) => fingerprint ?? "")) ?? "";
    try {
      await navigator.clipboard.writeText(link);
      this.lab.notice.say("The link is copied.");
    } catch {
      this.show("The link to this motion", link);
    }
  }

  async download(name: string) {
    const film = this.lab.film();
    this.lab.notice.say(
      name.endsWith("mp4")
        ? "The film is being made; this takes a while …"
        : { key: "Fetching {name} …", values: { name } },
    );
    saveBlob(await this.lab.backend.file(name, film.query), `hophoop-${name}`);
    this.lab.notice.say({ key: "{name} is there.", values: { name } });
  }

  async picture(kind: string, make: (shown: Kept) => Promise<Blob> | Blob) {
    saveBlob(await make(this.lab), `hophoop.${kind}`);
  }

  async record() {
    saveBlob(await record(this.lab), "hophoop.webm");
    this.lab.notice.say("The film is there.");
  }

  async code() {
    const { python, toml } = this.lab.backend.code(this.lab.film().scenario);
    this.show("The same motion in Python", python, "The scenario as a file", toml);
  }

  /** Headings and texts in turn. */
  show(...pairs: string[]) {
    const blocks = [];
    for (let i = 0; i < pairs.length; i += 2) {
      const text = pairs[i + 1];
      const copy = h("button", { type: "button" }, "Copy");
      copy.onclick = async () => {
        await navigator.clipboard?.writeText(text).catch(() => {});
        say(copy, "Copied");
      };
      blocks.push(
        h("header", {}, h("h2", {}, pairs[i]), copy),
        h("pre", { tabindex: "0" }, h("code", {}, document.createTextNode(text))),
      );
    }
    this.dialog.replaceChildren(
      ...blocks,
      h("button", { type: "button", class: "close", onclick: () => this.dialog.close() }, "Close"),
    );
    this.dialog.showModal();
  }
}
