// Share and save: link, downloads, picture, film recorded here, and the Python that makes the same motion.

import { h, saveBlob, say } from "../common/dom.ts";
import { icon } from "../common/icons.ts";
import { record } from "../player/recording.ts";
import { png, svg } from "../player/pictures.ts";
import type { Lab } from "./lab.ts";

/** What is kept, and who makes it. */
type Kept = Parameters<typeof record>[0] & Pick<Lab, "backend" | "film" | "link">;

const FILES = [
  ["motion.toml", "save.save_the_scenario_toml"],
  ["motion.csv", "save.save_the_states_csv"],
  ["motion.nc", "save.save_the_motion_netcdf"],
  ["motion.json", "save.save_the_events_json"],
  ["motion.mp4", "save.save_a_film_mp4"],
];

export class Share {
  menu = h(
    "details",
    { class: "menu" },
    h(
      "summary",
      { class: "button", "aria-label": "save.share_and_save" },
      h("span", { class: "long" }, "save.share_and_save"),
      h("span", { class: "short" }, icon("share")),
    ),
    h(
      "div",
      { class: "menu-body" },
      this.lab.backend.shares && [
        this.item("save.copy_a_link_to", () => this.copyLink([])),
        this.item("save.copy_a_link_with_fingerprint", () => this.copyLink(this.fingerprints()), "full"),
      ],
      FILES.filter(([name]) => this.lab.backend.files.includes(name)).map(([name, label]) =>
        this.item(label, () => this.download(name)),
      ),
      this.item("save.save_a_picture_png", () => this.picture("png", png)),
      this.item("save.save_a_picture_svg", () => this.picture("svg", svg)),
      this.item("save.record_one_run_as", () => this.record()),
      this.item("save.show_the_python_code", () => this.code()),
    ),
  );
  dialog = h("dialog", { class: "code-dialog", "aria-label": "save.the_same_motion_in" });

  constructor(readonly lab: Kept) {}

  /** `kind`: `full` where the simple view leaves it out. */
  item(label: string, action: () => void, kind = "") {
    return h(
      "button",
      {
        class: kind,
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

  fingerprints() {
    return this.lab.films().map(({ fingerprint }) => fingerprint);
  }

  async copyLink(fingerprints: string[]) {
    const link = this.lab.link(fingerprints) ?? "";
    try {
      await navigator.clipboard.writeText(link);
      this.lab.notice.say("save.the_link_is_copied");
    } catch {
      this.show("save.the_link_to_this", link);
    }
  }

  async download(name: string) {
    const film = this.lab.film();
    this.lab.notice.say(
      name.endsWith("mp4") ? "save.the_film_is_being" : { key: "save.fetching_name", values: { name } },
    );
    saveBlob(await this.lab.backend.file(name, film.query), `hophoop-${name}`);
    this.lab.notice.say({ key: "save.name_is_there", values: { name } });
  }

  async picture(kind: string, make: (shown: Kept) => Promise<Blob> | Blob) {
    saveBlob(await make(this.lab), `hophoop.${kind}`);
  }

  async record() {
    saveBlob(await record(this.lab), "hophoop.webm");
    this.lab.notice.say("save.the_film_is_there");
  }

  async code() {
    const { python, toml } = this.lab.backend.code(this.lab.film().scenario);
    this.show("save.the_same_motion_in", python, "save.the_scenario_as_a", toml);
  }

  /** Headings and texts in turn. */
  show(...pairs: string[]) {
    const blocks = [];
    for (let i = 0; i < pairs.length; i += 2) {
      const text = pairs[i + 1];
      const copy = h("button", {}, "motion.copy");
      copy.onclick = async () => {
        await navigator.clipboard?.writeText(text).catch(() => {});
        say(copy, "motion.copied");
      };
      blocks.push(
        h("header", {}, h("h2", {}, pairs[i]), copy),
        h("pre", { tabindex: "0" }, h("code", {}, document.createTextNode(text))),
      );
    }
    this.dialog.replaceChildren(
      ...blocks,
      h("button", { class: "close", onclick: () => this.dialog.close() }, "table.close"),
    );
    this.dialog.showModal();
  }
}
