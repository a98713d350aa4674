// Labelled fields of a form.
import { el, fresh } from "../../../report/src/dom";

export function area(label: string, rows: number): { box: HTMLElement; text: HTMLTextAreaElement } {
  const id = fresh("text");
  const text = el("textarea", { id });
  text.rows = rows;
  text.spellcheck = false;
  text.autocapitalize = "off";
  text.setAttribute("autocomplete", "off");
  return { box: el("div", { class: "area" }, el("label", { for: id }, label), text), text };
}

export function whole(label: string, value: number, min: number, max: number, after = ""): { box: HTMLElement; get: () => number; set: (to: number) => void } {
  const id = fresh("number");
  const input = el("input", { id, type: "number", value: String(value), min: String(min), max: String(max), step: "1" });
  const get = (): number => {
    const n = Math.round(Number(input.value));
    const kept = Number.isFinite(n) && input.value !== "" ? Math.max(min, Math.min(max, n)) : value;
    input.value = String(kept);
    return kept;
  };
  return { box: el("span", { class: "field" }, el("label", { for: id }, label), input, after), get, set: (to) => (input.value = String(to)) };
}

export function check(label: string): { box: HTMLElement; get: () => boolean; set: (to: boolean) => void } {
  const id = fresh("check");
  const input = el("input", { id, type: "checkbox" });
  return { box: el("span", { class: "field" }, input, el("label", { for: id }, label)), get: () => input.checked, set: (to) => (input.checked = to) };
}
