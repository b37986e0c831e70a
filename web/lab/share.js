// Keep and share: link, downloads, picture, film recorded here, and the Python that makes the same motion.

import { h, pen, saveBlob, say } from "./dom.js";
import { degrees, show } from "./numbers.js";
import { t } from "./words.js";

const FILES = [
  ["motion.toml", "Scenario (TOML)"],
  ["motion.csv", "States (CSV)"],
  ["motion.nc", "Motion (netCDF)"],
  ["motion.json", "Events (JSON)"],
  ["motion.mp4", "Film (MP4)"],
];

export class Share {
  /** @param {import("./lab.js").Lab} lab */
  constructor(lab) {
    this.lab = lab;
    this.menu = h(
      "details",
      { class: "menu" },
      h("summary", { class: "button" }, "Keep"),
      h(
        "div",
        { class: "menu-body" },
        lab.backend.shares && this.item("Copy the link", () => this.copyLink()),
        FILES.filter(([name]) => lab.backend.files?.includes(name) ?? true).map(([name, label]) =>
          this.item(label, () => this.download(name)),
        ),
        this.item("Picture (PNG)", () => this.picture()),
        this.item("Record a film here (WebM)", () => this.record()),
        this.item("Show me the Python", () => this.code()),
      ),
    );
    this.dialog = h("dialog", { class: "code-dialog", "aria-label": "The same motion in Python" });
    lab.root.addEventListener("pointerdown", (/** @type {PointerEvent} */ event) => {
      if (!this.menu.contains(/** @type {Node} */ (event.target))) this.menu.open = false;
    });
  }

  /**
   * @param {string} label
   * @param {() => void} action
   */
  item(label, action) {
    return h(
      "button",
      {
        type: "button",
        onclick: async () => {
          this.menu.open = false;
          try {
            await action();
          } catch (error) {
            this.lab.notice.fail(/** @type {Error} */ (error));
          }
        },
      },
      label,
    );
  }

  async copyLink() {
    const link = this.lab.link() ?? "";
    try {
      await navigator.clipboard.writeText(link);
      this.lab.notice.say("The link is copied.");
    } catch {
      this.show("The link to this motion", link);
    }
  }

  /** @param {string} name */
  async download(name) {
    const film = this.lab.film();
    this.lab.notice.say(name.endsWith("mp4") ? "The film is being made; this takes a while …" : `Fetching ${name} …`);
    saveBlob(await this.lab.backend.file(name, film.query), `hophoop-${name}`);
    this.lab.notice.say(`${name} is there.`);
  }

  picture() {
    this.lab.drawStage();
    const source = this.lab.stage.canvas();
    const copy = h("canvas", { width: source.width, height: source.height });
    this.copyInto(copy);
    return /** @type {Promise<void>} */ (
      new Promise((resolve) => {
        copy.toBlob((blob) => {
          if (blob) saveBlob(blob, "hophoop.png");
          resolve();
        }, "image/png");
      })
    );
  }

  /**
   * A copy of what is shown, with the words that stand beside it on the page.
   * @param {HTMLCanvasElement} canvas
   */
  copyInto(canvas) {
    const { lab } = this;
    const source = lab.stage.canvas();
    const context = pen(canvas);
    context.fillStyle = lab.theme.look.paper;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(source, 0, 0, canvas.width, canvas.height);
    const size = canvas.width / Math.max(source.getBoundingClientRect().width, 1);
    context.textBaseline = "top";
    context.textAlign = "left";
    const films = lab.films();
    for (const [i, film] of films.entries()) {
      const pose = film.at(lab.clock.time);
      const words = [
        films.length > 1 ? `${"AB"[i]}: ` : "",
        `${t(lab.theme.colors.mode_names[pose.mode])}, t = ${pose.t.toFixed(3)} s, θ = ${degrees(pose.angle)}, v = ${show(pose.vx, 3)} m/s`,
      ].join("");
      const top = lab.stage.options.three
        ? 10 + 20 * i
        : 10 + (i * source.getBoundingClientRect().height) / films.length;
      context.fillStyle = lab.theme.colors.modes[pose.mode];
      context.fillRect(12 * size, (top + 2) * size, 11 * size, 11 * size);
      context.fillStyle = lab.theme.look.ink;
      context.font = `${13 * size}px ${lab.theme.look.font}`;
      context.fillText(words, 30 * size, top * size);
    }
  }

  // The canvas itself, played once from the start, as WebM.
  async record() {
    const { lab } = this;
    const source = lab.stage.canvas();
    if (!source.captureStream || !globalThis.MediaRecorder) {
      throw new Error("This browser cannot record a canvas; take the MP4 instead.");
    }
    // films want even numbers of pixels
    const copy = h("canvas", { width: 2 * Math.ceil(source.width / 2), height: 2 * Math.ceil(source.height / 2) });
    const recorder = new MediaRecorder(copy.captureStream(60), { videoBitsPerSecond: 8e6 });
    /** @type {Blob[]} */
    const pieces = [];
    recorder.ondataavailable = (event) => pieces.push(event.data);
    const done = new Promise((resolve) => (recorder.onstop = resolve));
    const before = lab.clock.loop;
    lab.clock.loop = false;
    lab.clock.seek(0);
    lab.notice.say("Recording one run …");
    lab.afterFrame = () => {
      this.copyInto(copy);
      if (!lab.clock.playing && recorder.state === "recording") recorder.stop();
    };
    recorder.start();
    lab.clock.play(true);
    await done;
    lab.afterFrame = null;
    lab.clock.loop = before;
    saveBlob(new Blob(pieces, { type: recorder.mimeType }), "hophoop.webm");
    lab.notice.say("The film is there.");
  }

  async code() {
    const { header } = await this.lab.backend.call("code", { scenario: this.lab.film().scenario });
    this.show("The same motion in Python", header.python, "The scenario as a file", header.toml);
  }

  /**
   * Headings and texts in turn.
   * @param {...string} pairs
   */
  show(...pairs) {
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
