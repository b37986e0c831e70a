// Lines and curves instead of pixels: large, and only needed to keep a picture. The package is no module; its names are seen here.

export { Context } from "svgcanvas";
