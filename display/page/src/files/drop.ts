// Files dropped anywhere on the page go to the section that takes them.
import { el } from "../../../report/src/dom";
import { type Kind, kindOf } from "./kinds";

/** The message about files that no section takes. */
export function dropAnywhere(takers: Record<Kind, (files: File[]) => void>): HTMLElement {
  const message = el("p", { class: "wrong", role: "alert", id: "dropped" });
  message.hidden = true;
  const over = (is: boolean): void => void document.documentElement.classList.toggle("over", is);
  const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
  document.addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    over(true);
  });
  // The pointer left the window where no element is entered.
  document.addEventListener("dragleave", (event) => event.relatedTarget === null && over(false));
  document.addEventListener("drop", (event) => {
    over(false);
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length === 0) return;
    event.preventDefault();
    const kind = kindOf(files.map((f) => f.name));
    message.hidden = kind !== null;
    if (kind === null) {
      message.textContent = `${files.map((f) => f.name).join(", ")}: no section takes this. The page takes a scene (.glb, .gltf), an index function (.js, .mjs, .wgsl) and a result (.json).`;
      message.scrollIntoView({ block: "center" });
      return;
    }
    document.getElementById(kind)!.scrollIntoView();
    takers[kind](files);
  });
  return message;
}
