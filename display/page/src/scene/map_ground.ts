// The ground of a scene's micromap: its states.
import { curveIndex } from "../../../report/src/curve";
import { stateFills, stateName } from "../../../report/src/fills";
import { grouped } from "../../../report/src/format";
import { microOf } from "../walk/steps";
import type { Ground } from "../walk/walker";
import type { MapRecord } from "./read_maps";

export function mapGround(map: MapRecord, name: string): Ground {
  return {
    name,
    levels: [map.level, map.level],
    step: "micro",
    numbers: false,
    order: () => null,
    colours: () => {
      const fills = stateFills();
      return {
        fills,
        kind: (i, j, inverted) => map.at(curveIndex(i, j, inverted, map.level)),
        legend: fills.slice(0, map.states).map((fill, k) => ({ fill, words: stateName(String(k)) })),
      };
    },
    describe: (at) => {
      const m = microOf(at, map.level);
      const index = curveIndex(m.i, m.j, m.inverted, map.level);
      return `Micro-triangle ${grouped(index)} of ${grouped(4 ** map.level)}: ${stateName(String(map.at(index)))}.`;
    },
  };
}
