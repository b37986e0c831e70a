// The contact, to be heard: a low tone as strong as the normal force, a hiss while the rim slips, a knock at each
// landing. Silence is flight. Off until it is asked for; everything follows the computed motion at the film's time.

import { clamp } from "../common/clamp.ts";

const LOUDEST = 0.22;
const SOFT = 0.03; // seconds within which a loudness changes

/** What is to be heard at one instant, from the motion alone. Returns loudness from 0 to 1, pitch [Hz]. */
export function heard(film: Film, time: number) {
  const pose = film.at(time);
  const force = pose.mode === "H" || !(pose.normal_force > 0) ? 0 : pose.normal_force / film.weight;
  // the weight itself is at half loudness; a force that grows without bound only comes near to the whole
  const tone = force / (1 + force);
  const slipping = pose.mode === "S" || pose.mode === "K";
  const speed = Math.abs(pose.slip) / Math.sqrt((film.gravity || 9.81) * film.radius);
  return { tone, pitch: 55 * (1 + Math.min(force, 8)) ** 0.5, hiss: slipping ? tone * clamp(0.15 + speed, 0, 1) : 0 };
}

/** How hard the landings between two times are: the speed downwards, over that of a fall from a radius. */
function knocks(film: Film, from: number, to: number) {
  const scale = Math.sqrt(2 * (film.gravity || 9.81) * film.radius);
  return film.events
    .filter(({ kind, t }) => kind === "impact" && t > from && t <= to)
    .map(({ before }) => clamp(Math.abs(before.vy ?? 0) / scale, 0.02, 1));
}

function noise(context: AudioContext) {
  const buffer = context.createBuffer(1, context.sampleRate, context.sampleRate);
  const samples = buffer.getChannelData(0);
  // the same noise each time: a simple generator of numbers, without a choice
  let seed = 1;
  for (let i = 0; i < samples.length; i++) {
    seed = (seed * 16807) % 2147483647;
    samples[i] = (2 * seed) / 2147483647 - 1;
  }
  return buffer;
}

/** A tone and a hiss, both silent. */
function instrument() {
  const context = new AudioContext();
  const tone = context.createOscillator();
  tone.type = "triangle";
  const hiss = context.createBufferSource();
  hiss.buffer = noise(context);
  hiss.loop = true;
  const band = context.createBiquadFilter();
  band.type = "bandpass";
  band.frequency.value = 1800;
  band.Q.value = 0.6;
  const [low, high] = [context.createGain(), context.createGain()];
  low.gain.value = high.gain.value = 0;
  tone.connect(low).connect(context.destination);
  hiss.connect(band).connect(high).connect(context.destination);
  tone.start();
  hiss.start();
  const set = (value: AudioParam, to: number) => value.setTargetAtTime(to, context.currentTime, SOFT);
  const play = (now: ReturnType<typeof heard>) => {
    set(low.gain, LOUDEST * now.tone);
    set(high.gain, LOUDEST * 0.6 * now.hiss);
    set(tone.frequency, now.pitch);
  };
  return { context, play };
}

const SILENCE = { tone: 0, pitch: 55, hiss: 0 };

export class Sound {
  static heard = heard;
  static knocks = knocks;
  /** Made when it is first asked for. */
  made: ReturnType<typeof instrument> | null = null;
  on = false;
  last = 0;

  turn(on: boolean) {
    this.on = on;
    if (!on) return this.made?.play(SILENCE);
    this.made ??= instrument();
    this.made.context.resume();
  }

  /** The film has come to another time. */
  follow(film: Film, { playing, time }: Clock) {
    if (!this.on || !this.made) return;
    this.made.play(playing ? heard(film, time) : SILENCE);
    if (playing && time > this.last) for (const hard of knocks(film, this.last, time)) knock(this.made.context, hard);
    this.last = time;
  }

  close() {
    this.made?.context.close();
  }
}

function knock(context: AudioContext, hard: number) {
  const now = context.currentTime;
  const gain = context.createGain();
  gain.gain.setValueAtTime(2.2 * LOUDEST * Math.sqrt(hard), now);
  gain.gain.exponentialRampToValueAtTime(1e-4, now + 0.18);
  const body = context.createOscillator();
  body.frequency.setValueAtTime(190, now);
  body.frequency.exponentialRampToValueAtTime(60, now + 0.15);
  body.connect(gain).connect(context.destination);
  body.start(now);
  body.stop(now + 0.2);
}
