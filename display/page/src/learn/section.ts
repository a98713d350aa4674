// The two curves and ties, for somebody who has met neither.
import type { Order } from "../../../report/src/curve";
import { el, plainTable, select } from "../../../report/src/dom";
import { type At } from "../walk/steps";
import { Walker } from "../walk/walker";
import { digits, formula } from "./formula";
import { leafGround, type Way } from "./leaf_ground";
import { orderGround } from "./order_ground";
import { rowWords } from "./rows";

const p = (...words: (string | Node)[]): HTMLElement => el("p", {}, ...words);

function order(): HTMLElement {
  const path = el("p", { class: "path" });
  const steps = el("div", {});
  const numbers = el("details", { open: "" }, el("summary", {}, "The same by Vulkan's bits"), steps);
  let shown: Order = "curve";
  const moved = (at: At, level: number): void => {
    numbers.hidden = shown === "rows";
    if (shown === "rows") {
      path.textContent = rowWords(at, level);
      return;
    }
    const all = digits(at, level);
    const sum = all.map((d, k) => `${d} x ${4 ** (level - 1 - k)}`).join(" + ");
    path.textContent = level === 0 ? "Level 0: the triangle is not cut, and its index is 0." : `From the whole triangle down, the child is ${all.join(", then ")}: ${sum} = ${all.reduce((x, d) => 4 * x + d, 0)}.`;
    steps.replaceChildren(plainTable("The reference code at this point", ["", "Value", "What it is"], formula(at, level).map((s) => [s.name, el("code", {}, s.value), s.says])));
  };
  const walker = new Walker(orderGround("curve", moved), 2);
  const choose = select("Order", [{ value: "curve", words: "the curve of opacity micromaps" }, { value: "rows", words: "rows, of attribute micromaps" }], (value) => {
    shown = value as Order;
    walker.show(orderGround(shown, moved), walker.level);
  });
  // A tie to begin with.
  walker.go({ ku: 6, kv: 4 });
  return el("div", { id: "walk-order" }, el("div", { class: "tools" }, choose.box), el("div", { class: "beside" }, walker.root, el("div", {}, path, numbers)));
}

function leafPart(): HTMLElement {
  let way: Way = "rule";
  const walker = new Walker(leafGround(() => way), 3);
  const choose = select("States", [{ value: "rule", words: "by all of the micro-triangle: the rule" }, { value: "centre", words: "by its middle alone: wrong" }], (value) => {
    way = value as Way;
    walker.refresh();
  });
  return el("div", { id: "walk-leaf" }, el("div", { class: "tools" }, choose.box), walker.root);
}

export function learnSection(): HTMLElement[] {
  return [
    p("A ray meets a triangle in a point. Three weights say where: w, u and v, which add up to 1; w is 1 at the first corner, u at the second, v at the third. A micromap cuts the triangle into 4", el("sup", {}, "n"), " micro-triangles, n is its level, and keeps a state for each. So a point needs a number: the index of its micro-triangle."),
    el("h3", {}, "Two ways to count"),
    p(el("strong", {}, "The curve"), " cuts the triangle in four again and again. The child at the first corner is 0, the one in the middle is 1, then come 2 and 3. Four neighbours stay together at every level, so what is near on the triangle is near in memory, and the index divided by 4 is the index one level up. Opacity micromaps are counted so."),
    p(el("strong", {}, "Rows"), " count from the first corner, row after row; row r has 2r + 1 micro-triangles and begins at r x r. Attribute micromaps can be counted so. Going up a level changes all numbers."),
    el("h3", {}, "Walk: weights, index, ties"),
    p("Point at the triangle, or give it the focus and use the arrow keys. A step is a quarter of a micro-triangle's side, so the walk meets insides, edges and corners."),
    order(),
    el("h3", {}, "What a tie is"),
    p("A point on an edge belongs to two micro-triangles, a point on a corner to as many as six. That is a tie. Either answer is a triangle that holds the point, but two programs that choose differently read two different states there: one says leaf, the other says hole. Ties are rare in a photograph and common in a mesh whose vertices lie on a grid."),
    p("Vulkan's reference code decides: a point on a grid line goes to the micro-triangle on the side where u and v grow. On the long edge, where w is 0, there is nothing on that side, and the point goes to the one on the side where u is smaller; the third corner belongs to the last micro-triangle. The law ", el("code", {}, "index.rounding"), " says just that."),
    el("h3", {}, "Why a half-covered micro-triangle is never opaque"),
    p("A state speaks for every point of its micro-triangle, and no shader looks again. Opaque says: leaf everywhere. If the edge of the leaf goes through, some rays meet leaf and some meet air, and one bit cannot say which. Then the state is unknown, and the shader reads the texture. Higher levels leave less area unknown; they never make a half-covered one opaque."),
    leafPart(),
  ];
}
