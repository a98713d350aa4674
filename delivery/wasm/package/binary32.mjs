// Arithmetic as a shader's: operations on numbers, each rounded to binary32, as Math.fround rounds.
//
// A product, sum, difference, quotient or root of binary32 numbers that is rounded to binary64 and then to binary32 is the
// one that is rounded to binary32 at once, as 53 >= 2 * 24 + 2 (S. Figueroa, When is double rounding innocuous?, 1995).
// Whole numbers below 2^53 are taken for integers: an operation on two of them whose result is one stays as it is, so that
// indices and bits above 2^24 are what they are in JavaScript.
const whole = Number.isSafeInteger;
const { fround } = Math;
const rounded = (result, a, b) => (typeof result !== "number" || (whole(a) && whole(b) && whole(result)) ? result : fround(result));

/** Functions that take the place of operators. */
const operations = {
  add: (a, b) => rounded(a + b, a, b),
  subtract: (a, b) => rounded(a - b, a, b),
  multiply: (a, b) => rounded(a * b, a, b),
  divide: (a, b) => rounded(a / b, a, b),
  remainder: (a, b) => rounded(a % b, a, b),
  power: (a, b) => rounded(a ** b, a, b),
  number: (a) => (whole(+a) ? +a : fround(a)),
  next: (a) => (typeof a === "bigint" ? a + 1n : operations.add(+a, 1)),
  previous: (a) => (typeof a === "bigint" ? a - 1n : operations.subtract(+a, 1)),
  /** The value of an assignment: no statement may begin with a parenthesis that the line before did not expect. */
  value: (a) => a,
  /** The value before: of a++, whose second argument assigns. */
  before: (a) => (typeof a === "bigint" ? a : +a),
  place: (object, key) => new Place(object, key),
};

/** A member that is assigned to: its object and key are evaluated once, and it is read before the other operand. */
class Place {
  constructor(object, key) {
    this.object = object;
    this.key = key;
    this.value = object[key];
  }
  set(name, operand) {
    return (this.object[this.key] = operations[name](this.value, operand));
  }
  step(name) {
    this.set(name);
    return operations.before(this.value);
  }
}

// These return one of their arguments, a whole number, or a rounded one.
const asTheyAre = new Set(["abs", "ceil", "clz32", "floor", "fround", "imul", "max", "min", "round", "sign", "trunc"]);
const binary32Math = Object.fromEntries(
  Object.getOwnPropertyNames(Math).map((name) => {
    const value = Math[name];
    if (typeof value === "number") return [name, fround(value)];
    if (asTheyAre.has(name)) return [name, value];
    return [name, (...given) => {
      const result = value(...given);
      return given.every(whole) && whole(result) ? result : fround(result);
    }];
  }),
);

/** The name by which rewritten text calls the operations. */
export const operationsName = "__mmverify_binary32";
/** The values of the names that rewritten text uses without declaring them. */
export const scope = { [operationsName]: operations, Math: binary32Math };
export const scopeNames = Object.keys(scope);

/** The words of a verdict about the numbers that it is about. */
export const arithmeticWords = {
  binary32: "each operation rounded to binary32, between whole numbers exact",
  binary64: "in binary64, as JavaScript computes; in binary32, as shaders do, it may answer otherwise",
};
