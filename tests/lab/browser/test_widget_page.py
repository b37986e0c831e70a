"""The notebook widget in a browser: the same player."""

import base64
import gzip

import pytest

import hophoop as hh
from lab_page_tools import picture, summary, until


def opened(visit, module=None):
    """A page with the widget, as a notebook shows it; and the widget."""
    pytest.importorskip("anywidget")
    page = visit(own=True, bypass_csp=True)  # notebooks allow scripts from blobs
    widget = hh.show(hh.simulate(hh.Scenario(duration=2.0)), panels=("controls", "plots"))
    sent = []
    widget.send = lambda content, buffers=None: sent.append((content, buffers))

    def kernel(message):
        widget._answer(widget, message, [])
        content, buffers = sent.pop()
        return {"content": content, "buffers": [base64.b64encode(part).decode() for part in buffers or []]}

    page.expose_function("kernel", kernel)
    page.expose_function("chosen", lambda query: setattr(widget, "query", query))
    page.evaluate(
        """async ({ given, panels, module, scripts, start }) => {
          const bytes = (text) => {
            const raw = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
            return new DataView(raw.buffer);
          };
          const listeners = [];
          const traits = { given, panels, module: bytes(module), scripts, query: "" };
          const model = {
            get: (name) => traits[name],
            set: (name, value) => (traits[name] = value),
            save_changes: () => chosen(traits.query),
            on: (name, listener) => name === "msg:custom" && listeners.push(listener),
            off: () => {},
            send: async (message) => {
              const { content, buffers } = await kernel(message);
              for (const listener of listeners) listener(content, buffers.map(bytes));
            },
          };
          const source = URL.createObjectURL(new Blob([start], { type: "text/javascript" }));
          const { default: widget } = await import(source);
          document.body.replaceChildren();
          const el = document.createElement("div");
          document.body.append(el);
          globalThis.leave = await widget.render({ model, el });
        }""",
        {
            "given": widget.given,
            "panels": widget.panels,
            "module": base64.b64encode(widget.module if module is None else module).decode(),
            "scripts": widget.scripts,
            "start": widget._esm,
        },
    )
    return page, widget


def test_the_widget_is_the_same_player(visit):
    page, widget = opened(visit)
    page.locator(".embedded[data-ready]").wait_for()
    assert "hops at 315.6°" in summary(page)
    assert page.locator(".map").count() == 0
    # keys that Jupyter would take to delete cells and to make them text
    page.evaluate("globalThis.heard = []; document.addEventListener('keydown', ({ key }) => heard.push(key))")
    page.locator(".stage").click()
    page.keyboard.press("d")
    page.keyboard.press("m")
    assert page.evaluate("heard") == []
    assert page.locator(".embedded").get_attribute("data-lm-suppress-shortcuts") == "true"
    page.locator("input[data-path='start.speed']").fill("2")
    page.wait_for_function("() => document.querySelector('.summary').textContent === 'Rolls.'")
    # the page shows what it computed and tells the notebook then
    until(page, lambda: widget.motion.scenario.start.speed == 2.0 and widget.query == "duration=2&start.speed=2")
    # undo takes the notebook's motion back as well
    page.get_by_role("button", name="Undo (z)").click()
    page.wait_for_function("() => document.querySelector('.summary').textContent.includes('hops')")
    until(page, lambda: widget.motion.scenario.start.speed == 3.1 and widget.query == "duration=2")
    picture(page, "widget")
    page.get_by_role("button", name="Arrows").click()
    page.locator(".more-said li").first.wait_for()  # their module has come from the notebook's kernel
    page.evaluate("leave()")


def test_a_browser_without_webassembly_is_told(visit):
    page, _ = opened(visit, gzip.compress(b"not a module"))
    page.get_by_text("This needs a browser that runs WebAssembly.").wait_for()
    page.evaluate("leave()")
