// The picture itself, played once from the start and recorded by the browser: as MP4 where it can, else as WebM.

import { h } from "../common/dom.ts";
import { copyInto } from "./pictures.ts";
import type { Lab } from "../shell/lab.ts";

const KINDS = ["video/mp4;codecs=avc1", "video/webm"];

export async function record(lab: Parameters<typeof copyInto>[0] & Pick<Lab, "notice" | "afterFrame">): Promise<Blob> {
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
