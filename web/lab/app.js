// The lab: one or two motions, the clock, and everything that shows them.

import { Clock } from "./clock.js";
import { degrees, h, icon, length, once, readable, show, theme, withUnit } from "./dom.js";
import { Film } from "./frames.js";
import { build } from "./layout.js";
import { Stage3D } from "./stage3d.js";

const STEP = 1 / 60;

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
    if (!hosted) {
      root.classList.add("embedded");
      // Jupyter would take the same keys to delete cells and to restart the kernel
      root.dataset.lmSuppressShortcuts = "true";
      root.dataset.pSuppressShortcuts = "true";
    }
  }

  async start({ setup, films, queries = [""], time = 0 }) {
    this.setup = setup ?? (await this.backend.call("setup", {})).header;
    this.colors = this.setup.colors;
    build(this);
    this.watchTheme();
    if (films) this.lanes = films.map((reply) => ({ film: new Film(reply) }));
    else await this.load(queries);
    this.clock.time = time;
    this.remember();
    this.show();
    this.clock.listeners.add(() => this.request());
    new ResizeObserver(() => this.show()).observe(this.stageBox);
    this.root.dataset.ready = "true";
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
    this.story.announce(this.films());
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
      this.story.announce(this.films());
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

  // Another motion, from outside.
  replace(reply) {
    this.lanes[this.active].film = new Film(reply);
    this.clear();
    this.show();
    this.remember();
  }

  close() {
    this.clock.playing = false;
    this.asked?.abort();
    this.map.asked?.abort();
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
    this.addressed();
  }

  link() {
    const other = this.lanes.length > 1 ? `#with=${encodeURIComponent(this.film(1).query)}` : "";
    return this.backend.link(this.film(0).query, other);
  }

  addressed() {
    this.undoButton.disabled = !this.past.length;
    this.redoButton.disabled = !this.future.length;
    if (this.hosted) history.replaceState(null, "", this.link());
    this.onmotion?.(this.film().query);
  }

  // --- showing -------------------------------------------------------------------------------

  // All that depends on the motion; `since` is when the hand moved that asked for it.
  show(since = null) {
    const films = this.films();
    if (!films.length) return;
    this.look = theme(this.root);
    this.inks = { ...this.colors };
    for (const name of ["gravity_center", "airborne", "normal_force", "friction_force"]) {
      this.inks[name] = readable(this.colors[name], this.look.dark);
    }
    this.clock.duration = Math.max(...films.map((film) => film.duration));
    this.clock.time = Math.min(this.clock.time, this.clock.duration);
    const two = films.length > 1;
    this.compareButton.setAttribute("aria-pressed", String(two));
    this.root.classList.toggle("two", two);
    this.tabBar.hidden = !two;
    for (const [i, tab] of this.tabs.entries()) tab.setAttribute("aria-pressed", String(i === this.active));
    for (const [name, button] of this.switches) button.setAttribute("aria-pressed", String(this.options[name]));
    this.drawStage();
    this.drawReadout();
    this.controls.show(this.film());
    if (since !== null && since !== undefined) {
      requestAnimationFrame(() => setTimeout(() => this.latencies.push(performance.now() - since), 0));
    }
    // the picture first; diagrams and words follow once it is on the screen
    if (!this.surrounding) {
      this.surrounding = true;
      requestAnimationFrame(() => setTimeout(() => this.showSurroundings(), 0));
    }
  }

  showSurroundings() {
    this.surrounding = false;
    const films = this.films();
    this.timeline.draw(films, this.look, this.colors);
    this.plots.draw(films, this.active, this.look);
    this.phase.draw(films, this.active, this.look);
    this.story.draw(films, this.active, this.colors);
    this.drawTime();
    this.map.mark(this.film());
    this.stageBox.setAttribute("aria-label", `The hoop. ${films.map((film) => film.summary).join(" ")}`);
    this.later();
  }

  stageCanvas() {
    return this.options.three ? this.canvas3 : this.canvas2;
  }

  drawStage() {
    const { clock, options, look, inks } = this;
    this.legend.hidden = !options.speed;
    this.stageKeys.at(-1).hidden = !(options.three && this.lanes.length > 1);
    this.fastest.textContent = `≥ ${show(Math.max(...this.films().map((film) => film.extent.speed)), 2)} m/s`;
    if (options.three) {
      this.stage3 ??= new Stage3D(this.canvas3, () => this.request());
      this.stage3.draw(this.films(), clock.time, options, look, inks, clock.playing);
    } else this.stage2.draw(this.films(), clock.time, options, look, inks);
  }

  drawTime() {
    const { clock } = this;
    if (this.surrounding) return;
    this.timeline.draw(this.films(), this.look, this.colors);
    this.plots.cursor(clock.time);
    this.phase.cursor(clock.time);
    this.story.cursor(clock.time);
    const title = clock.playing ? "Pause (space)" : "Play (space)";
    if (this.playButton.title !== title || !this.playButton.firstChild) {
      this.playButton.replaceChildren(icon(clock.playing ? "pause" : "play"));
      this.playButton.title = title;
      this.playButton.setAttribute("aria-label", title);
    }
    if (this.speeds.value !== String(clock.speed)) this.speeds.value = String(clock.speed);
  }

  drawReadout() {
    const film = this.film();
    const pose = film.at(this.clock.time);
    const rows = [
      ["hoop", this.lanes.length > 1 ? "AB"[this.active] : ""],
      ["mode", this.colors.mode_names[pose.mode]],
      ["time", `${pose.t.toFixed(3)} s`],
      ["angle", degrees(pose.angle)],
      ["v", withUnit(show(pose.vx, 3), "m/s")],
      ["R θ̇", withUnit(show(pose.omega * film.radius, 3), "m/s")],
      ["gap", pose.height > 0 ? length(pose.height) : "0"],
    ];
    if (!this.outputs) {
      this.outputs = rows.map(([name]) => [name, h("dd", {})]);
      this.readout.replaceChildren(...this.outputs.flatMap(([name, value]) => [h("dt", {}, name), value]));
    }
    rows.forEach(([, value], i) => {
      if (this.outputs[i][1].textContent !== value) this.outputs[i][1].textContent = value;
    });
    this.outputs[0][1].hidden = this.outputs[0][1].previousSibling.hidden = this.lanes.length < 2;
    this.outputs[1][1].className = "mode";
    this.outputs[1][1].style.setProperty("--mode", this.colors.modes[pose.mode]);
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
    this.drawReadout();
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
      this.theory.draw(reply.header.thresholds, this.lanes.length > 1 ? "AB"[this.active] : "");
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
