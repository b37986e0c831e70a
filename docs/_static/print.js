// Folded solutions are unfolded on paper, and folded again afterwards.
const folded = [];
addEventListener("beforeprint", () => {
  for (const box of document.querySelectorAll("details:not([open])")) {
    box.open = true;
    folded.push(box);
  }
});
addEventListener("afterprint", () => {
  for (const box of folded.splice(0)) box.open = false;
});
