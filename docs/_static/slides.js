// Arrow keys, space and Page Up/Down go from slide to slide; the film of a slide plays while it is shown.
const slides = [...document.querySelectorAll("section")];
const place = document.querySelector("footer");
let shown = 0;

const seen = new IntersectionObserver(
  (entries) => {
    for (const entry of entries) {
      const film = entry.target.querySelector("video");
      if (entry.isIntersecting) {
        shown = slides.indexOf(entry.target);
        place.textContent = `${shown + 1} / ${slides.length}`;
        film?.play().catch(() => {});
      } else film?.pause();
    }
  },
  { threshold: 0.6 },
);
for (const slide of slides) seen.observe(slide);

addEventListener("keydown", (event) => {
  const way = { ArrowRight: 1, ArrowDown: 1, PageDown: 1, " ": 1, ArrowLeft: -1, ArrowUp: -1, PageUp: -1 }[event.key];
  if (!way || ["VIDEO", "SUMMARY"].includes(event.target.tagName)) return;
  event.preventDefault();
  slides[Math.min(Math.max(shown + way, 0), slides.length - 1)].scrollIntoView();
});
