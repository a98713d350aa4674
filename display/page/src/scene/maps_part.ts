// The micromaps of a file, one at a time, to walk about in.
import { button, el, fresh } from "../../../report/src/dom";
import { plural } from "../../../report/src/format";
import { Walker } from "../walk/walker";
import { mapGround } from "./map_ground";
import type { MapRecord } from "./read_maps";

export function mapsPart(maps: MapRecord[], title: string): HTMLElement {
  let shown = 0;
  const about = el("output", {});
  const ground = () => {
    const map = maps[shown]!;
    about.textContent = `of ${maps.length}: level ${map.level}, ${plural(map.states, "state")}`;
    return mapGround(map, `Micromap ${shown + 1} of ${maps.length}`);
  };
  // The most varied to begin with: the highest level of which more than one state is seen.
  const varied = (map: MapRecord): boolean => Array.from({ length: 64 }, (_, k) => map.at(Math.floor((k / 64) * 4 ** map.level))).some((s, _, all) => s !== all[0]);
  shown = Math.max(0, maps.findIndex((m) => m.level >= 3 && varied(m)));
  const walker = new Walker(ground(), maps[shown]!.level);
  const id = fresh("map");
  const number = el("input", { id, type: "number", min: "1", max: String(maps.length), value: String(shown + 1) });
  const show = (k: number): void => {
    if (!Number.isInteger(k)) return;
    shown = Math.max(0, Math.min(maps.length - 1, k));
    number.value = String(shown + 1);
    walker.show(ground(), maps[shown]!.level);
  };
  number.addEventListener("change", () => show(Number(number.value) - 1));
  return el(
    "div",
    { class: "maps" },
    el("h3", {}, title),
    el(
      "div",
      { class: "tools" },
      el("span", { class: "field" }, el("label", { for: id }, "Micromap"), number, about),
      button("Previous map", () => show(shown - 1)),
      button("Next map", () => show(shown + 1)),
    ),
    walker.root,
  );
}
