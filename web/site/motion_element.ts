// <hophoop-motion scenario="plane.mu=0.5&start.speed=2.8" panels="controls plots">: a live hoop in any page.
//
// One tag and one script. Everything is computed in the visitor's browser; nothing is sent anywhere. With loading="lazy" it begins
// when a visitor comes near it, as pictures do.

const here = new URL("./", import.meta.url);
let count = 0;

/** When an element is about to be seen. */
function seen(element: Element) {
  return new Promise<void>((resolve) => {
    const near = new IntersectionObserver(
      ([entry]) => {
        if (!entry.isIntersecting) return;
        near.disconnect();
        resolve();
      },
      { rootMargin: "200px" },
    );
    near.observe(element);
  });
}

class HophoopMotion extends HTMLElement {
  static observedAttributes = ["scenario"];

  lab: any = null;
  number: number;

  constructor() {
    super();
    this.number = ++count;
  }

  async connectedCallback() {
    if (this.getAttribute("loading") === "lazy") await seen(this);
    if (this.shadowRoot) return;
    const shadow = this.attachShadow({ mode: "open" });
    const style = document.createElement("link");
    style.rel = "stylesheet";
    style.href = new URL("lab.css", here).href;
    const frame = document.createElement("style");
    frame.textContent = ":host { display: block; min-height: 18rem; } :host([hidden]) { display: none; }";
    const root = document.createElement("div");
    root.textContent = "The hoop is loading …";
    shadow.append(style, frame, root);
    try {
      const { mount } = await import(new URL("lab.js", here).href);
      root.textContent = "";
      this.lab = await mount(root, here, this.scenario, this.panels);
      this.dispatchEvent(new Event("ready"));
    } catch (error) {
      root.textContent = (error as Error).message;
    }
  }

  disconnectedCallback() {
    this.lab?.close();
  }

  attributeChangedCallback(_: string, before: string | null, now: string | null) {
    if (this.lab && before !== now) this.lab.open([now ?? ""]);
  }

  get scenario() {
    return (this.getAttribute("scenario") ?? "").replace(/^\?/, "");
  }

  get panels() {
    return (this.getAttribute("panels") ?? "").split(/[\s,]+/).filter(Boolean);
  }
}

customElements.define("hophoop-motion", HophoopMotion);
