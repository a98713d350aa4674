// The hint below a pasted function: what it is written in, and the command that judges it.
import { el } from "../../../report/src/dom";
import type { Hint } from "./hint";

export function hintPart(): { root: HTMLElement; show: (hint: Hint | null) => void } {
  const root = el("p", { class: "hint", role: "status" });
  root.hidden = true;
  return {
    root,
    show: (hint) => {
      root.hidden = hint === null;
      root.replaceChildren(...(hint ? [hint.words, ...(hint.commands ?? []).flatMap(({ on, line }, k) => [`${k > 0 ? ";" : ""}${on ? ` ${on}` : ""}: `, el("code", {}, line)]), "."] : []));
    },
  };
}
