// Lines and curves instead of pixels: large, and only needed to keep a picture.

export { Context } from "svgcanvas";
