// Colours that the colour-blind tell apart (Okabe and Ito's, some darkened for white paper), and shapes besides.

export type Scheme = "light" | "dark";

const light = ["#0072b2", "#d55e00", "#008a66", "#a83f83", "#8a6a00", "#33739e", "#4d4d4d"];
const dark = ["#56b4e9", "#ff8d3f", "#2fc79b", "#e79cc6", "#f0c64a", "#9fd0f0", "#c8c8c8"];

export const shapes = ["circle", "square", "triangle", "diamond", "cross", "plus"] as const;
export type Shape = (typeof shapes)[number];

export interface Look {
  /** A place in the palette. */
  colour: number;
  shape: Shape;
}

/** The k-th series' look: colour and shape together are the series' own up to 42 of them. */
export const look = (k: number): Look => ({ colour: k % light.length, shape: shapes[k % shapes.length]! });

/** Whether the page is light or dark now; theme.ts says so. */
export const scheme = (): Scheme => (document.documentElement.dataset["theme"] === "dark" ? "dark" : "light");

export const colour = (k: number): string => (scheme() === "dark" ? dark : light)[k % light.length]!;

/** A colour that the style sheet names. */
export const named = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** Draws a shape of radius r around a point. */
export function trace(c: CanvasRenderingContext2D | Path2D, shape: Shape, x: number, y: number, r: number): void {
  switch (shape) {
    case "circle":
      c.moveTo(x + r, y);
      c.arc(x, y, r, 0, 2 * Math.PI);
      break;
    case "square":
      c.rect(x - 0.88 * r, y - 0.88 * r, 1.76 * r, 1.76 * r);
      break;
    case "triangle":
      c.moveTo(x, y - 1.2 * r);
      c.lineTo(x + 1.1 * r, y + 0.8 * r);
      c.lineTo(x - 1.1 * r, y + 0.8 * r);
      c.closePath();
      break;
    case "diamond":
      c.moveTo(x, y - 1.25 * r);
      c.lineTo(x + 1.25 * r, y);
      c.lineTo(x, y + 1.25 * r);
      c.lineTo(x - 1.25 * r, y);
      c.closePath();
      break;
    case "cross":
      c.moveTo(x - r, y - r);
      c.lineTo(x + r, y + r);
      c.moveTo(x - r, y + r);
      c.lineTo(x + r, y - r);
      break;
    case "plus":
      c.moveTo(x - 1.2 * r, y);
      c.lineTo(x + 1.2 * r, y);
      c.moveTo(x, y - 1.2 * r);
      c.lineTo(x, y + 1.2 * r);
      break;
  }
}

/** Cividis at eleven places. Source: Nunez, Anderton and Renslow, 2018. */
const cividis = [
  [0, 34, 78], [18, 53, 112], [59, 73, 108], [87, 93, 109], [112, 113, 115], [138, 134, 120], [165, 156, 116], [195, 179, 105],
  [225, 204, 85], [254, 232, 56],
] as const;

/** 256 colours from the start of an order to its end, as words of an ImageData. */
export function gradient(): Uint32Array {
  const words = new Uint32Array(256);
  for (let k = 0; k < 256; ++k) {
    const at = (k / 255) * (cividis.length - 1);
    const low = Math.min(Math.floor(at), cividis.length - 2);
    const mix = (c: 0 | 1 | 2) => Math.round(cividis[low]![c] + (at - low) * (cividis[low + 1]![c] - cividis[low]![c]));
    words[k] = word(mix(0), mix(1), mix(2));
  }
  return words;
}

/** An opaque pixel as an ImageData's 32-bit word, on machines that keep the low byte first. */
export const word = (r: number, g: number, b: number): number => ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;

/** "#0072b2" as such a word. */
export function wordOf(hex: string): number {
  const n = Number.parseInt(hex.slice(1), 16);
  return word(n >> 16, (n >> 8) & 255, n & 255);
}
