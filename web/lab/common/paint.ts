// What pictures are drawn of: lines, areas, circles, and words that stand out from what is below them.

type Pen = CanvasRenderingContext2D;

function through(context: Pen, points: number[][]) {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
}

/** A line through points. */
export function stroke(context: Pen, ...points: number[][]) {
  through(context, points);
  context.stroke();
}

/** An area between points. */
export function fill(context: Pen, ...points: number[][]) {
  through(context, points);
  context.fill();
}

function around(context: Pen, [x, y]: number[], radius: number) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

export function ring(context: Pen, place: number[], radius: number, color = context.strokeStyle, width?: number) {
  around(context, place, radius);
  context.strokeStyle = color;
  context.lineWidth = width ?? context.lineWidth;
  context.stroke();
}

export function disc(context: Pen, place: number[], radius: number, color = context.fillStyle) {
  around(context, place, radius);
  context.fillStyle = color;
  context.fill();
}

/** The head of an arrow, from its tip against its direction. */
export function arrowHead(context: Pen, [x, y]: number[], [ux, uy]: number[], length: number) {
  const [bx, by, half] = [x - ux * length, y - uy * length, 0.5 * length];
  fill(context, [x, y], [bx - uy * half, by + ux * half], [bx + uy * half, by - ux * half]);
}

/** Twice: broad in the paper's colour, then thinner in its own. */
export function outlined(context: Pen, paper: [string, number], ink: [string, number], draw: (width: number) => void) {
  for (const [color, width] of [paper, ink]) {
    context.strokeStyle = context.fillStyle = color;
    context.lineWidth = width;
    draw(width);
  }
}

/** Words with a rim of the paper's colour. */
export function haloed(context: Pen, text: string, [x, y]: number[], ink: string, paper: string) {
  context.lineWidth = 4;
  context.strokeStyle = paper;
  context.strokeText(text, x, y);
  context.fillStyle = ink;
  context.fillText(text, x, y);
}
