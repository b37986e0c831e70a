// Pictures of what is shown, larger than the screen, with the words that stand beside it on the page.

import { fetched, h, pen } from "../common/dom.ts";
import { degrees, show } from "../common/numbers.ts";
import { t } from "../words/words.ts";
import type { Lab } from "../shell/lab.ts";

/** What a picture is made of. */
type Shown = Pick<Lab, "stage" | "clock" | "theme" | "films" | "drawStage">;

const WIDE = 3840; // pixels across a picture that is kept

export async function png(lab: Shown): Promise<Blob> {
  const { width, height } = lab.stage.canvas().getBoundingClientRect();
  const ratio = Math.max(WIDE / width, globalThis.devicePixelRatio || 1);
  const canvas = h("canvas", { width: Math.round(width * ratio), height: Math.round(height * ratio) });
  const context = pen(canvas);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  background(context, lab, width, height);
  if (lab.stage.options.three) {
    context.drawImage(lab.stage.sharp(lab, ratio), 0, 0, width, height);
    lab.drawStage();
  } else flat(context, lab, width, height);
  words(context, lab, height);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("save.picture_too_large")))),
  );
}

/** As lines and curves, which stay sharp at any size. */
export async function svg(lab: Shown) {
  if (lab.stage.options.three) throw new Error("save.no_svg_in_space");
  const { width, height } = lab.stage.canvas().getBoundingClientRect();
  const { Context } = await fetched(import("./svg.ts"));
  const context = new Context({ width, height, document });
  background(context, lab, width, height);
  flat(context, lab, width, height);
  words(context, lab, height);
  return new Blob([context.getSerializedSvg()], { type: "image/svg+xml" });
}

/** A copy of what is on the screen, as a film takes it. */
function copyInto(lab: Shown, canvas: HTMLCanvasElement) {
  const source = lab.stage.canvas();
  const { width, height } = source.getBoundingClientRect();
  const context = pen(canvas);
  context.setTransform(canvas.width / width, 0, 0, canvas.height / height, 0, 0);
  background(context, lab, width, height);
  context.drawImage(source, 0, 0, width, height);
  words(context, lab, height);
}

function background(context: CanvasRenderingContext2D, { theme }: Shown, width: number, height: number) {
  context.fillStyle = theme.look.paper;
  context.fillRect(0, 0, width, height);
}

function flat(context: CanvasRenderingContext2D, lab: Shown, width: number, height: number) {
  const { stage, clock, theme } = lab;
  stage.flat.paint(context, width, height, lab.films(), clock.time, stage.options, theme);
}

/** Mode, time, angle and speed of each hoop, in its part of the picture. */
function words(context: CanvasRenderingContext2D, lab: Shown, height: number) {
  const { theme, stage, clock } = lab;
  const { px } = theme.look;
  const films = lab.films();
  context.textBaseline = "top";
  context.textAlign = "left";
  for (const [i, film] of films.entries()) {
    const pose = film.at(clock.time);
    const hoop = films.length > 1 ? `${"AB"[i]}: ` : "";
    const mode = t(theme.colors.mode_names[pose.mode]);
    const numbers = `t = ${pose.t.toFixed(3)} s, θ = ${degrees(pose.angle)}, v = ${show(pose.vx, 3)} m/s`;
    const top = stage.options.three ? 10 + 20 * px * i : 10 + (i * height) / films.length;
    context.fillStyle = theme.colors.modes[pose.mode];
    context.fillRect(12, top + 2 * px, 11 * px, 11 * px);
    context.fillStyle = theme.look.ink;
    context.font = `${13 * px}px ${theme.look.font}`;
    context.fillText(`${hoop}${mode}, ${numbers}`, 12 + 18 * px, top);
  }
  context.textBaseline = "alphabetic";
}

// --- The picture itself, played once from the start and recorded by the browser: as MP4 where it can, else as WebM

const KINDS = ["video/mp4;codecs=avc1", "video/webm"];

export async function record(lab: Parameters<typeof copyInto>[0] & Pick<Lab, "notice" | "afterFrame">) {
  const source = lab.stage.canvas();
  const mimeType = KINDS.find((kind) => globalThis.MediaRecorder?.isTypeSupported(kind));
  if (!("captureStream" in source && mimeType)) throw new Error("save.cannot_record");
  // films want even numbers of pixels
  const copy = h("canvas", { width: 2 * Math.ceil(source.width / 2), height: 2 * Math.ceil(source.height / 2) });
  const recorder = new MediaRecorder(copy.captureStream(60), { mimeType, videoBitsPerSecond: 8e6 });
  const pieces: Blob[] = [];
  recorder.ondataavailable = (event) => pieces.push(event.data);
  const done = new Promise<any>((resolve) => (recorder.onstop = resolve));
  const { loop } = lab.clock;
  lab.clock.loop = false;
  lab.clock.seek(0);
  lab.notice.say("save.recording");
  lab.afterFrame = () => {
    copyInto(lab, copy);
    if (!lab.clock.playing && recorder.state === "recording") recorder.stop();
  };
  recorder.start();
  lab.clock.play(true);
  await done;
  lab.afterFrame = null;
  lab.clock.loop = loop;
  return new Blob(pieces, { type: recorder.mimeType });
}
