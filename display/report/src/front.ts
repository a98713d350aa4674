// The Pareto front: what nothing else beats in both directions.

export interface Place {
  x: number;
  y: number;
}

/** Those of the places that no other one is better than: less or equal in both x and y, and less in one.
 * In order of x. Of places that coincide all are on the front. */
export function front<P extends Place>(places: readonly P[]): P[] {
  const sorted = [...places].sort((a, b) => a.x - b.x || a.y - b.y);
  const found: P[] = [];
  let least = Infinity;
  let last: P | undefined;
  for (const p of sorted) {
    if (p.y < least || (last && p.x === last.x && p.y === last.y)) {
      found.push(p);
      last = p;
      least = Math.min(least, p.y);
    }
  }
  return found;
}
