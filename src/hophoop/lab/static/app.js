// The lab: one or two motions, the clock, and everything that shows them.

import { Clock, SPEEDS } from "./clock.js";
import { Controls } from "./controls.js";
import { h, once, show, theme, withUnit } from "./dom.js";
import { Film } from "./frames.js";
import { MotionMap } from "./map.js";
import { PhasePlane } from "./phase.js";
import { Plots } from "./plots.js";
import { Share } from "./share.js";
import { Stage2D } from "./stage2d.js";
import { Stage3D } from "./stage3d.js";
import { Story, Theory } from "./story.js";
import { Timeline } from "./timeline.js";

const STEP = 1 / 60;
const SWITCHES = [
  ["traces", "Traces", "t"],
  ["forces", "Forces", "f"],
  ["speed", "Rim speed", "c"],
  ["whole", "Whole path", "w"],
];

export class Lab {
  // `hosted`: the lab owns the page, with its address and its keyboard
  constructor(root, backend, { hosted = false, panels = null } = {}) {
    Object.assign(this, { root, backend, hosted, panels });
    this.clock = new Clock();
    this.lanes = [];
    this.active = 0;
    this.options = { traces: true, forces: true, speed: true, whole: false, three: false };
    this.past = [];
    this.future = [];
    this.latencies = [];
    this.frame = this.frame.bind(this);
    this.later = once(() => this.fetchTheory(), 120);
    root.classList.add("hophoop");
    if (!hosted) root.classList.add("embedded");
  }

  async start({ setup, films, queries = [""], time = 0 }) {
    this.setup = setup ?? (await this.backend.call("setup", {})).header;
    this.colors = this.setup.colors;
    this.build();
    this.watchTheme();
    if (films) this.lanes = films.map((reply) => ({ film: new Film(reply) }));
    else await this.load(queries);
    this.clock.time = time;
    this.remember();
    this.show();
    this.clock.listeners.add(() => this.request());
    new ResizeObserver(() => this.show()).observe(this.stageBox);
    root_ready(this.root);
  }

  // --- building ------------------------------------------------------------------------------

  build() {
    const { clock } = this;
    this.canvas2 = h("canvas", { class: "stage-canvas" });
    this.canvas3 = h("canvas", { class: "stage-canvas", hidden: true });
    this.stage2 = new Stage2D(this.canvas2);
    this.stage2.onview = () => this.request();
    this.readout = h("dl", { class: "readout", "aria-hidden": "true" });
    this.stageBox = h(
      "div",
      { class: "stage", role: "img", "aria-label": "The hoop", tabindex: "0" },
      this.canvas2,
      this.canvas3,
      this.readout,
    );
    this.timeline = new Timeline(clock);
    this.story = new Story(clock);
    this.theory = new Theory();
    this.plots = new Plots(clock, this.colors);
    this.phase = new PhasePlane(this);
    this.map = new MotionMap(this);
    this.controls = new Controls(this.setup.controls, (changes, commit) => this.change(changes, commit));
    this.share = new Share(this);
    this.message = h("p", { class: "message", role: "alert", hidden: true });
    const want = (name) => !this.panels || this.panels.includes(name);
    const side = h(
      "aside",
      { class: "side", "aria-label": "Parameters" },
      this.lanesBar(),
      this.message,
      this.controls.element,
    );
    const main = h(
      "div",
      { class: "middle" },
      h("div", { class: "player" }, this.stageBox, this.timeline.element, this.transport()),
      h("div", { class: "words" }, this.story.element, want("theory") && this.theory.element),
      want("map") && this.map.element,
    );
    const why = h(
      "div",
      { class: "why" },
      want("plots") && this.plots.element,
      want("plots") && this.phase.element,
    );
    this.toast = h("div", { class: "toast", role: "status", hidden: true });
    this.root.replaceChildren(
      this.header(),
      h("div", { class: "columns" }, want("controls") && side, main, why),
      this.toast,
      this.share.dialog,
      this.help(),
    );
    if (!want("controls")) this.root.classList.add("no-controls");
    const keys = (event) => this.key(event);
    if (this.hosted) document.addEventListener("keydown", keys);
    else this.root.addEventListener("keydown", keys);
  }

  header() {
    const groups = new Map();
    for (const preset of this.setup.presets) {
      groups.set(preset.group, [...(groups.get(preset.group) ?? []), preset]);
    }
    this.presets = h(
      "select",
      {
        class: "presets",
        "aria-label": "Motions to start from",
        onchange: () => {
          const preset = this.setup.presets.find(({ key }) => key === this.presets.value);
          if (preset) this.take(preset.query, preset);
        },
      },
      h("option", { value: "" }, "Motions to start from …"),
      [...groups].map(([group, list]) =>
        h("optgroup", { label: group }, list.map(({ key, title }) => h("option", { value: key }, title))),
      ),
    );
    const button = (label, title, action, extra = {}) =>
      h("button", { type: "button", title, "aria-label": title, onclick: action, ...extra }, label);
    this.undoButton = button("↶", "Undo (z)", () => this.undo());
    this.redoButton = button("↷", "Redo (y)", () => this.redo());
    this.compareButton = button("Compare", "Compare two hoops", () => this.compare(), { "aria-pressed": "false" });
    return h(
      "header",
      { class: "top" },
      h("h1", {}, h("span", { class: "logo", "aria-hidden": "true" }), "hophoop lab"),
      this.presets,
      h("div", { class: "buttons" }, this.undoButton, this.redoButton, this.compareButton),
      h(
        "div",
        { class: "buttons right" },
        this.share.menu,
        button("◐", "Dark or light (d)", () => this.toggleTheme()),
        button("?", "Keys and help (?)", () => this.helpDialog.showModal()),
      ),
    );
  }

  lanesBar() {
    this.tabs = ["A", "B"].map((name, i) =>
      h("button", { type: "button", role: "tab", onclick: () => this.choose(i) }, `Hoop ${name}`),
    );
    this.tabBar = h("div", { class: "tabs", role: "tablist", "aria-label": "Which hoop", hidden: true }, this.tabs);
    this.presetText = h("p", { class: "preset-text" });
    return h("div", {}, this.tabBar, this.presetText);
  }

  transport() {
    const button = (label, title, action) =>
      h("button", { type: "button", title, "aria-label": title, onclick: action }, label);
    this.playButton = button("▶", "Play (space)", () => this.clock.play());
    this.playButton.classList.add("play");
    this.speeds = h(
      "select",
      {
        "aria-label": "Speed of the film",
        onchange: () => {
          this.clock.speed = Number(this.speeds.value);
        },
      },
      SPEEDS.map((speed) => h("option", { value: String(speed) }, `${speed}×`)),
    );
    this.speeds.value = "1";
    this.switches = new Map(
      SWITCHES.map(([name, label, key]) => {
        const box = h("button", {
          type: "button", class: "switch", title: `${label} (${key})`, onclick: () => this.toggle(name),
        }, label);
        return [name, box];
      }),
    );
    this.threeButton = h(
      "button", { type: "button", class: "switch", title: "In space (3)", onclick: () => this.toggle("three") }, "3D",
    );
    this.switches.set("three", this.threeButton);
    return h(
      "div",
      { class: "transport" },
      h(
        "div",
        { class: "buttons" },
        button("⏮", "To the start (Home)", () => this.clock.seek(0)),
        button("⇤", "Previous event (Shift ←)", () => this.jump(-1)),
        button("◂", "One frame back (←)", () => this.nudge(-1)),
        this.playButton,
        button("▸", "One frame on (→)", () => this.nudge(1)),
        button("⇥", "Next event (Shift →)", () => this.jump(1)),
      ),
      h(
        "div",
        { class: "buttons" },
        button("▲ hop", "To the next take-off (h)", () => this.jump(1, "takeoff")),
        button("▼ landing", "To the next landing (l)", () => this.jump(1, "impact")),
      ),
      this.speeds,
      h("div", { class: "buttons switches" }, [...this.switches.values()]),
    );
  }

  help() {
    const keys = [
      ["space", "play, pause"], ["← →", "one frame"], ["Shift ← →", "previous, next event"], ["h  l", "next hop, landing"],
      ["[ ]", "slower, faster"], ["Home End", "start, end"], ["t f c w", "traces, forces, rim speed, whole path"],
      ["3", "in space"], ["+ − 0", "zoom, zoom back"], ["z y", "undo, redo"], ["d", "dark, light"], ["p", "Python"],
    ];
    this.helpDialog = h(
      "dialog",
      { class: "help", "aria-label": "Keys and help" },
      h("h2", {}, "The hoop"),
      h(
        "p",
        {},
        "A ring with a load on its rim rolls on a plane. Friction can only hold so much, and the plane can only push: " +
          "so it slips, hops, lands – or does something that rigid-body mechanics cannot decide. Move a slider and see.",
      ),
      h("table", {}, h("caption", {}, "Keys"), keys.map(([key, what]) => h("tr", {}, h("th", { scope: "row" }, key), h("td", {}, what)))),
      h("p", { class: "hint" }, `hophoop ${this.setup.version}`),
      h("button", { type: "button", class: "close", onclick: () => this.helpDialog.close() }, "Close"),
    );
    return this.helpDialog;
  }

  // --- scenarios -----------------------------------------------------------------------------

  film(lane = this.active) {
    return this.lanes[lane].film;
  }

  films() {
    return this.lanes.map((lane) => lane.film);
  }

  async load(queries) {
    const replies = await Promise.all(queries.map((query) => this.backend.call("film", { query })));
    this.lanes = replies.map((reply) => ({ film: new Film(reply) }));
    this.active = Math.min(this.active, this.lanes.length - 1);
  }

  // Each move of a slider; only the latest of each parameter is asked for while an answer is under way.
  change(changes, commit) {
    const lane = this.lanes[this.active];
    lane.since ??= performance.now();
    lane.pending = [...(lane.pending ?? []).filter(([path]) => !changes.some(([other]) => other === path)), ...changes];
    lane.commit ||= commit;
    this.pump(lane);
  }

  async pump(lane) {
    if (lane.busy || !lane.pending) {
      if (!lane.busy && lane.commit) this.settle(lane);
      return;
    }
    const changes = lane.pending;
    const { since } = lane;
    lane.pending = null;
    lane.since = null;
    lane.busy = true;
    try {
      const reply = await this.backend.call("film", { scenario: lane.film.scenario, changes });
      lane.film = new Film(reply);
      this.presets.value = "";
      this.clear();
      this.show(since);
    } catch (error) {
      this.fail(error);
    } finally {
      lane.busy = false;
    }
    this.pump(lane);
  }

  settle(lane) {
    lane.commit = false;
    this.remember();
    this.story.announce();
  }

  async take(query, preset = null) {
    try {
      const reply = await this.backend.call("film", { query });
      this.lanes[this.active].film = new Film(reply);
      this.clear();
      this.clock.time = 0;
      this.presetText.textContent = preset?.text ?? "";
      this.show();
      this.remember();
      this.story.announce();
    } catch (error) {
      this.fail(error);
    }
  }

  remember() {
    const now = this.films().map((film) => film.query);
    if (this.now && JSON.stringify(this.now) !== JSON.stringify(now)) {
      this.past.push(this.now);
      if (this.past.length > 500) this.past.shift();
      this.future = [];
    }
    this.now = now;
    this.addressed();
  }

  async undo() {
    if (this.past.length) await this.travel(this.past, this.future);
  }

  async redo() {
    if (this.future.length) await this.travel(this.future, this.past);
  }

  async travel(from, to) {
    const queries = from.pop();
    to.push(this.now);
    this.now = queries;
    await this.load(queries);
    this.clear();
    this.presetText.textContent = "";
    this.show();
    this.addressed();
  }

  compare() {
    if (this.lanes.length === 1) {
      this.lanes.push({ film: this.lanes[0].film });
      this.active = 1;
    } else {
      this.lanes.splice(1 - this.active, 1);
      this.active = 0;
    }
    this.show();
    this.remember();
  }

  choose(lane) {
    this.active = lane;
    this.show();
  }

  link() {
    const other = this.lanes.length > 1 ? `#with=${encodeURIComponent(this.film(1).query)}` : "";
    return this.backend.link(this.film(0).query, other);
  }

  addressed() {
    this.undoButton.disabled = !this.past.length;
    this.redoButton.disabled = !this.future.length;
    if (this.hosted) history.replaceState(null, "", this.link());
  }

  // --- showing -------------------------------------------------------------------------------

  // All that depends on the motion; `since` is when the hand moved that asked for it.
  show(since = null) {
    const films = this.films();
    if (!films.length) return;
    this.look = theme(this.root);
    this.clock.duration = Math.max(...films.map((film) => film.duration));
    this.clock.time = Math.min(this.clock.time, this.clock.duration);
    const two = films.length > 1;
    this.compareButton.setAttribute("aria-pressed", String(two));
    this.tabBar.hidden = !two;
    this.tabs.forEach((tab, i) => tab.setAttribute("aria-selected", String(i === this.active)));
    for (const [name, button] of this.switches) button.setAttribute("aria-pressed", String(this.options[name]));
    this.drawStage();
    this.controls.show(this.film());
    this.plots.draw(films, this.look);
    this.phase.draw(films, this.look);
    this.story.draw(films, this.colors);
    this.drawTime();
    this.map.mark(this.film());
    this.stageBox.setAttribute("aria-label", `The hoop. ${films.map((film) => film.summary).join(" ")}`);
    this.later();
    if (since !== null && since !== undefined) {
      requestAnimationFrame(() => setTimeout(() => this.latencies.push(performance.now() - since), 0));
    }
  }

  stageCanvas() {
    return this.options.three ? this.canvas3 : this.canvas2;
  }

  drawStage() {
    const { clock, options, look, colors } = this;
    if (options.three) {
      this.stage3 ??= new Stage3D(this.canvas3, () => this.request());
      this.stage3.draw(this.films(), clock.time, options, look, colors);
    } else this.stage2.draw(this.films(), clock.time, options, look, colors);
  }

  drawTime() {
    const { clock } = this;
    this.timeline.draw(this.films(), this.look, this.colors);
    this.plots.cursor(clock.time);
    this.phase.cursor(clock.time);
    this.story.cursor(clock.time);
    const title = clock.playing ? "Pause (space)" : "Play (space)";
    this.playButton.textContent = clock.playing ? "❚❚" : "▶";
    this.playButton.title = title;
    this.playButton.setAttribute("aria-label", title);
    this.speeds.value = String(clock.speed);
    this.drawReadout();
  }

  drawReadout() {
    const film = this.film();
    const pose = film.at(this.clock.time);
    const rows = [
      ["mode", this.colors.mode_names[pose.mode]],
      ["time", `${pose.t.toFixed(3)} s`],
      ["angle", `${((pose.angle * 180) / Math.PI).toFixed(1)}°`],
      ["v", withUnit(show(pose.vx, 3), "m/s")],
      ["R θ̇", withUnit(show(pose.omega * film.radius, 3), "m/s")],
      ["gap", pose.height > 0 ? withUnit(show(pose.height * 100, 3), "cm") : "0"],
    ];
    if (!this.outputs) {
      this.outputs = rows.map(([name]) => [name, h("dd", {})]);
      this.readout.replaceChildren(...this.outputs.flatMap(([name, value]) => [h("dt", {}, name), value]));
    }
    rows.forEach(([, value], i) => {
      if (this.outputs[i][1].textContent !== value) this.outputs[i][1].textContent = value;
    });
    this.outputs[0][1].style.setProperty("--mode", this.colors.modes[pose.mode]);
  }

  request() {
    if (this.requested) return;
    this.requested = true;
    requestAnimationFrame(this.frame);
  }

  frame(now) {
    this.requested = false;
    if (!this.lanes.length) return;
    this.clock.tick(now);
    this.drawStage();
    this.drawTime();
    this.afterFrame?.();
    this.frames = (this.frames ?? 0) + 1;
    if (this.clock.playing) this.request();
  }

  async fetchTheory() {
    const { scenario } = this.film();
    this.asked?.abort();
    this.asked = new AbortController();
    try {
      const reply = await this.backend.call("theory", { scenario }, this.asked.signal);
      this.theory.draw(reply.header.thresholds);
      await this.phase.fetch(scenario, this.asked.signal);
    } catch (error) {
      if (error.name !== "AbortError") this.theory.draw([{ label: "–", text: error.message }]);
    }
  }

  fail(error) {
    this.message.textContent = error.message;
    this.message.hidden = false;
    if (!this.message.isConnected) this.say(error.message);
  }

  clear() {
    this.message.hidden = true;
  }

  say(text) {
    this.toast.textContent = text;
    this.toast.hidden = false;
    clearTimeout(this.toastTimer);
    this.toastTimer = setTimeout(() => (this.toast.hidden = true), 4000);
  }

  // --- hands ---------------------------------------------------------------------------------

  toggle(name) {
    this.options[name] = !this.options[name];
    if (name === "three") {
      try {
        this.canvas2.hidden = this.options.three;
        this.canvas3.hidden = !this.options.three;
        this.drawStage();
      } catch (error) {
        this.options.three = false;
        this.canvas2.hidden = false;
        this.canvas3.hidden = true;
        this.say(error.message);
      }
    }
    this.switches.get(name)?.setAttribute("aria-pressed", String(this.options[name]));
    this.request();
  }

  nudge(way) {
    this.clock.playing = false;
    this.clock.seek(this.clock.time + way * STEP * Math.min(this.clock.speed, 1));
  }

  jump(way, kind = null) {
    this.clock.playing = false;
    const times = this.films()
      .flatMap((film) => film.events)
      .filter((event) => (kind ? event.kind === kind : true))
      .map((event) => event.t)
      .sort((a, b) => a - b);
    const now = this.clock.time;
    let next = way > 0 ? times.find((t) => t > now + 1e-9) : times.findLast((t) => t < now - 1e-9);
    if (next === undefined && kind) next = times[0];
    if (next === undefined) {
      if (kind) this.say(kind === "takeoff" ? "This motion has no hop." : "This motion has no landing.");
      return;
    }
    this.clock.seek(next);
  }

  zoom(factor) {
    if (this.options.three) this.stage3.zoomBy(factor);
    else if (factor) this.stage2.zoomBy(factor);
    else this.stage2.reset();
  }

  key(event) {
    const { target } = event;
    if (event.ctrlKey || event.metaKey || event.altKey || this.root.querySelector("dialog[open]")) return;
    if (target.matches?.("input:not([type=range]), textarea, select")) return;
    const sliding = target.matches?.("input[type=range]") && /^(Arrow|Home|End|Page)/.test(event.key);
    if (sliding || (event.key === " " && target.matches?.("button, summary"))) return;
    const actions = {
      " ": () => this.clock.play(),
      ArrowLeft: () => (event.shiftKey ? this.jump(-1) : this.nudge(-1)),
      ArrowRight: () => (event.shiftKey ? this.jump(1) : this.nudge(1)),
      Home: () => this.clock.seek(0),
      End: () => this.clock.seek(this.clock.duration),
      h: () => this.jump(1, "takeoff"),
      l: () => this.jump(1, "impact"),
      "[": () => this.clock.faster(-1),
      "]": () => this.clock.faster(1),
      t: () => this.toggle("traces"),
      f: () => this.toggle("forces"),
      c: () => this.toggle("speed"),
      w: () => this.toggle("whole"),
      3: () => this.toggle("three"),
      "+": () => this.zoom(1.25),
      "=": () => this.zoom(1.25),
      "-": () => this.zoom(0.8),
      0: () => this.zoom(0),
      z: () => this.undo(),
      y: () => this.redo(),
      d: () => this.toggleTheme(),
      p: () => this.share.code(),
      "?": () => this.helpDialog.showModal(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  watchTheme() {
    const media = matchMedia("(prefers-color-scheme: dark)");
    const apply = () => {
      const kept = this.hosted ? stored("hophoop-theme") : null;
      this.root.dataset.theme = this.chosenTheme ?? kept ?? (media.matches ? "dark" : "light");
      if (this.hosted) document.documentElement.style.colorScheme = this.root.dataset.theme;
      this.show();
      this.map.redraw();
    };
    media.addEventListener("change", apply);
    this.applyTheme = apply;
    apply();
  }

  toggleTheme() {
    this.chosenTheme = this.root.dataset.theme === "dark" ? "light" : "dark";
    if (this.hosted) store("hophoop-theme", this.chosenTheme);
    this.applyTheme();
  }
}

// Storage may be forbidden; the choice then lasts as long as the page.
function stored(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

function store(key, value) {
  try {
    localStorage.setItem(key, value);
  } catch {
    // nothing to keep
  }
}

function root_ready(root) {
  root.dataset.ready = "true";
}
