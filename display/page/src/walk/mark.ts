// Where somebody stands: the micro-triangle's outline, and the point.
import { cornersOf, type Micro } from "../../../report/src/curve";

export function outline(c: CanvasRenderingContext2D, m: Micro, level: number, pixel: (u: number, v: number) => [number, number]): void {
  const N = 2 ** level;
  const k = cornersOf(m);
  c.beginPath();
  c.moveTo(...pixel(k[0] / N, k[1] / N));
  c.lineTo(...pixel(k[2] / N, k[3] / N));
  c.lineTo(...pixel(k[4] / N, k[5] / N));
  c.closePath();
}

export function mark(
  c: CanvasRenderingContext2D,
  m: Micro,
  level: number,
  pixel: (u: number, v: number) => [number, number],
  point: [number, number] | null,
  named: (name: string) => string,
): void {
  outline(c, m, level, pixel);
  for (const [colour, width] of [["paper", 6], ["right", 3]] as const) {
    c.strokeStyle = named(colour);
    c.lineWidth = width;
    c.stroke();
  }
  if (!point) return;
  c.beginPath();
  c.arc(...point, 5.5, 0, 2 * Math.PI);
  c.fillStyle = "#000";
  c.fill();
  c.strokeStyle = "#fff";
  c.lineWidth = 2;
  c.stroke();
}
