// Elements, made without markup: what comes from a file only ever becomes text.

type Child = Node | string | null | undefined | false;

export interface Props {
  class?: string;
  id?: string;
  title?: string;
  [attribute: `aria-${string}`]: string;
  [attribute: `data-${string}`]: string;
  role?: string;
  type?: string;
  for?: string;
  value?: string;
  tabindex?: string;
  scope?: string;
  colspan?: string;
  href?: string;
  placeholder?: string;
  min?: string;
  max?: string;
  step?: string;
  checked?: string;
  name?: string;
  open?: string;
  alt?: string;
  src?: string;
}

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) if (value !== undefined) element.setAttribute(name, value);
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
  return element;
}

/** SVG of our own making: tag, attributes, children. */
export function svg(tag: string, attributes: Record<string, string | number>, ...children: Node[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

export function button(words: string, act: () => void, props: Props = {}): HTMLButtonElement {
  const made = el("button", { type: "button", ...props }, words);
  made.addEventListener("click", act);
  return made;
}

/** A table of texts in a box of its own, which scrolls sideways if it must; numbers go to the right. */
export function plainTable(caption: string, head: string[], rows: (string | Node)[][]): HTMLElement {
  const numeric = head.map((_, k) => rows.every((row) => typeof row[k] !== "string" || /^[−\-\d.,]*( ?[%\p{L}]{0,3})?$/u.test(row[k])));
  const look = (content: string | Node, k: number) => (numeric[k] ? "number" : typeof content === "string" && content.length > 24 ? "long" : "");
  const cell = (content: string | Node, k: number) => el("td", { class: look(content, k) }, content);
  return el(
    "div",
    { class: "scrolls", tabindex: "0", role: "region", "aria-label": caption },
    el(
      "table",
      { class: "plain" },
      el("caption", {}, caption),
      el("thead", {}, el("tr", {}, ...head.map((words, k) => el("th", { scope: "col", ...(numeric[k] ? { class: "number" } : {}) }, words)))),
      el("tbody", {}, ...rows.map((row) => el("tr", {}, ...row.map(cell)))),
    ),
  );
}

let numbers = 0;
/** An id that no other element has. */
export const fresh = (stem: string): string => `${stem}-${++numbers}`;

/** A labelled drop-down list. */
export function select(label: string, options: { value: string; words: string }[], chosen: (value: string) => void) {
  const id = fresh("select");
  const list = el("select", { id }, ...options.map((o) => el("option", { value: o.value }, o.words)));
  list.addEventListener("change", () => chosen(list.value));
  return { box: el("span", { class: "field" }, el("label", { for: id }, label), list), list };
}
