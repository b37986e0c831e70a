"""Delays put at random into a page, as a busy machine has them: fetches, answers of workers, ways in the history, frames."""

import pytest

# Each kind of delay has its own stream of the seed, so that one more fetch does not move the frames.
SCRIPT = """
(() => {
  const MOST = { fetch: 400, answer: 400, way: 700, frame: 700 }; // milliseconds
  const stream = (state) => () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
  const [fetches, answers, frames, ways] = [1, 2, 3, 4].map((kind) => stream(4 * SEED + kind));

  const go = history.go.bind(history);
  history.go = (way) => setTimeout(go, ways() * MOST.way, way);

  const { fetch } = globalThis;
  globalThis.fetch = async (...asked) => {
    await new Promise((resolve) => setTimeout(resolve, fetches() * MOST.fetch));
    return fetch(...asked);
  };

  // answers stay in the order in which a worker gave them
  const heard = Object.getOwnPropertyDescriptor(Worker.prototype, "onmessage");
  Object.defineProperty(Worker.prototype, "onmessage", {
    ...heard,
    set(listener) {
      let last = Promise.resolve();
      heard.set.call(this, (event) => {
        const wait = answers() * MOST.answer;
        last = last.then(() => new Promise((resolve) => setTimeout(resolve, wait))).then(() => listener.call(this, event));
      });
    },
  });

  const { requestAnimationFrame: ask, cancelAnimationFrame: cancel } = globalThis;
  const waiting = new Map();
  let count = 0;
  globalThis.requestAnimationFrame = (draw) => {
    const handle = ++count;
    const begin = () => {
      const frame = ask((now) => {
        waiting.delete(handle);
        draw(now);
      });
      waiting.set(handle, () => cancel(frame));
    };
    if (frames() < 0.1) {
      const timer = setTimeout(begin, frames() * MOST.frame);
      waiting.set(handle, () => clearTimeout(timer));
    } else begin();
    return handle;
  };
  globalThis.cancelAnimationFrame = (handle) => {
    waiting.get(handle)?.();
    waiting.delete(handle);
  };
})();
"""


def delaying(seed):
    """The script that puts delays into a page before anything else runs there."""
    return SCRIPT.replace("SEED", str(seed))


SEEDS = [None, pytest.param(11, marks=pytest.mark.long)]
also_delayed = pytest.mark.parametrize("visit", SEEDS, indirect=True, ids=["at_once", "delayed"])
"""A test of the page that is run once more with delays: it must wait for what comes."""
