// The page as one file, which opens from a disk: it holds as texts what a folder has as files.

import { addressesOf, unpacked } from "../kernel/packed.ts";

const element = (id: string) => document.getElementById(id) as HTMLElement;
const held = (name: string) =>
  Uint8Array.from(atob(element(`packed-${name}`).textContent ?? ""), (letter) => letter.charCodeAt(0));

const addressOf = addressesOf(await unpacked(held("scripts")).json());
const { default: lab } = await import(addressOf("lab.js"));
lab.open(element("hophoop-file"), held, addressOf("worker.js"));
