// Inputs that a verdict on an index function leaves open.

/** The highest level that there is. */
const highest = 16;

/** `to`: the highest level that was asked; `floats`: whether floats beside the grid's points were drawn. */
export function notAsked(to: number, floats: boolean): string[] {
  const left: string[] = [];
  if (to < highest) left.push(to + 1 < highest ? `levels ${to + 1} to ${highest}` : `level ${highest}`);
  left.push(floats ? "all other floats: of each level a million were drawn" : 'floats beside the grid\'s points, which "also a million floats near ties a level" would ask');
  return left;
}
