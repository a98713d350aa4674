// Light, dark, or as the system has it.
import { button } from "./dom";
import { scheme } from "./palette";

const changed = new Set<() => void>();

/** Calls back whenever the colours change. */
export const onTheme = (act: () => void): void => void changed.add(act);

const tell = () => changed.forEach((act) => act());

export function themeButton(): HTMLButtonElement {
  const root = document.documentElement;
  const words = () => (scheme() === "dark" ? "Light colours" : "Dark colours");
  const toggle = button(words(), () => {
    root.dataset["theme"] = scheme() === "dark" ? "light" : "dark";
    tell();
  });
  onTheme(() => (toggle.textContent = words()));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", tell);
  return toggle;
}
