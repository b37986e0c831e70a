// The page that makes the tag, the frame and the QR code for a scenario.

import qr from "qrcode-generator";

const site = new URL("../", import.meta.url);

// the words of the lab, and its choice of a language
const lab = await import("../lab/shell/main.ts");
const { current, languageMenu, name, repeat, say, speakFrom, t } = lab;

const find = (id: string) => document.getElementById(id) as any;

const escaped = (text: string) => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

// What people paste: the query of a link, or the whole link.
function queryOf(text: string) {
  const plain = text.trim();
  const place = plain.indexOf("?");
  const query = place >= 0 ? plain.slice(place + 1) : plain.includes("=") ? plain : "";
  return query.split("#")[0];
}

function show() {
  const query = queryOf(find("scenario").value);
  const panels = [...document.querySelectorAll("input[name=panel]:checked")].map((box) => (box as any).value);
  const link = new URL(query ? `?${query}` : "", site).href;
  const tag =
    `<script type="module" src="${new URL("static/hophoop-motion.js", site).href}"></script>\n` +
    `<hophoop-motion scenario="${escaped(query)}"${panels.length ? ` panels="${panels.join(" ")}"` : ""}></hophoop-motion>`;
  const frame = `<iframe src="${escaped(link)}" title="${escaped(t("embed.frame_title"))}" width="100%" height="700" loading="lazy"></iframe>`;
  find("tag").value = tag;
  find("frame").value = frame;
  find("link").textContent = link;
  find("link").href = link;
  find("code").innerHTML = qrcode(link);
  const element = document.createElement("hophoop-motion");
  element.setAttribute("scenario", query);
  element.setAttribute("panels", panels.join(" "));
  find("example").replaceChildren(element);
}

async function copy({ target }: any) {
  await navigator.clipboard.writeText(find(target.dataset.copies).value);
  say(find("said"), "embed.copied");
}

function spoken() {
  document.documentElement.lang = current();
  document.title = find("title").textContent;
  find("said").textContent = "";
  show();
}

await speakFrom(new URL("./", import.meta.url));
// the page holds keys; from now on its words follow the language
for (const element of document.querySelectorAll("[data-said]")) say(element, element.getAttribute("data-said") ?? "");
for (const element of document.querySelectorAll("[data-label]")) {
  name(element, "aria-label", element.getAttribute("data-label") ?? "");
}
find("language").append(
  languageMenu(() => {
    repeat(document.body);
    spoken();
  }),
);
find("scenario").value = location.search.slice(1);
for (const input of document.querySelectorAll("input")) input.addEventListener("change", show);
for (const button of document.querySelectorAll("button[data-copies]")) button.addEventListener("click", copy);
spoken();

// --- A QR code as an SVG: dark on light whatever the page's colours, since cameras read it so

function qrcode(text: string) {
  const code = qr(0, "M");
  code.addData(text);
  code.make();
  const count = code.getModuleCount();
  let path = "";
  for (let row = 0; row < count; row++) {
    for (let column = 0; column < count; column++) {
      if (code.isDark(row, column)) path += `M${column + 4} ${row + 4}h1v1h-1z`;
    }
  }
  const size = count + 8;
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size} ${size}" role="img" aria-label="QR code of the link">` +
    `<path fill="#fff" d="M0 0h${size}v${size}H0z"/><path fill="#000" d="${path}"/></svg>`
  );
}
