// <hophoop-motion scenario="plane.mu=0.5&start.speed=2.8" panels="controls plots">: a live hoop in any page.
//
// One tag and one script. Everything is computed in the visitor's browser; nothing is sent anywhere. With loading="lazy" it begins
// when a visitor comes near it, as pictures do.

const here = new URL("./", import.meta.url);

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
  root: HTMLElement | null = null;
  starting = false;

  async connectedCallback() {
    if (this.getAttribute("loading") === "lazy") await seen(this);
    if (this.shadowRoot) return;
    const shadow = this.attachShadow({ mode: "open" });
    const style = document.createElement("link");
    style.rel = "stylesheet";
    style.href = new URL("lab.css", here).href;
    const frame = document.createElement("style");
    frame.textContent = ":host { display: block; min-height: 18rem; } :host([hidden]) { display: none; }";
    this.root = document.createElement("div");
    shadow.append(style, frame, this.root);
    this.start(this.root);
  }

  /** What is wrong with the scenario is said in the place of the hoop. */
  async start(root: HTMLElement) {
    this.starting = true;
    root.textContent = "…";
    try {
      const { mount } = await import("../lab/shell/main.ts");
      this.lab = await mount(root, here, this.scenario, this.panels);
      if (this.lab) this.dispatchEvent(new Event("ready"));
    } catch (error) {
      root.textContent = error.message; // of the browser: the page's words are in the script that is missing
    }
    this.starting = false;
  }

  disconnectedCallback() {
    this.lab?.close();
  }

  attributeChangedCallback(_: string, before: string | null, now: string | null) {
    if (before === now || !this.root || this.starting) return;
    const { lab } = this;
    if (!lab) this.start(this.root);
    else
      lab.open([now ?? ""]).then(
        () => lab.notice.clear(),
        (error: Error) => lab.notice.fail(error),
      );
  }

  get scenario() {
    return (this.getAttribute("scenario") ?? "").replace(/^\?/, "");
  }

  get panels() {
    return (this.getAttribute("panels") ?? "").split(/[\s,]+/).filter(Boolean);
  }
}

customElements.define("hophoop-motion", HophoopMotion);
