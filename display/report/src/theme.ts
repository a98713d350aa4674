// Light, dark, or as the system has it.
import { button } from "./dom";
import { type Scheme, scheme } from "./palette";

const changed = new Set<() => void>();

/** Calls back whenever the colours change. */
export const onTheme = (act: () => void): void => void changed.add(act);

function become(next: Scheme): void {
  document.documentElement.dataset["theme"] = next;
  changed.forEach((act) => act());
}

/** As the system has it, until it is pressed. */
export function themeButton(): HTMLButtonElement {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const follow = (): void => become(dark.matches ? "dark" : "light");
  const words = (): string => (scheme() === "dark" ? "Light colours" : "Dark colours");
  dark.addEventListener("change", follow);
  follow();
  const toggle = button(words(), () => {
    dark.removeEventListener("change", follow);
    become(scheme() === "dark" ? "light" : "dark");
  });
  onTheme(() => (toggle.textContent = words()));
  return toggle;
}
