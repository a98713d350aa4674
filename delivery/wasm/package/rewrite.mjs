// JavaScript rewritten so that each operation on numbers is one of binary32.mjs.
import { parse } from "acorn";

import { operationsName } from "./binary32.mjs";

const binary = { "+": "add", "-": "subtract", "*": "multiply", "/": "divide", "%": "remainder", "**": "power" };
const bindsText = new Set(["eval", "Function"]);

/** Names what cannot be rounded, by its line. */
export class CannotRound extends Error {}

class Rewriting {
  constructor(text) {
    this.text = text;
  }

  refuse(node, why) {
    throw new CannotRound(`line ${node.loc.start.line}: ${this.text.slice(node.start, node.end).split("\n")[0]}: ${why}`);
  }

  /** The node's text; that of its children is rewritten. */
  of(node) {
    return this.special(node) ?? this.copied(node);
  }

  copied(node) {
    let out = "";
    let at = node.start;
    for (const child of children(node)) {
      out += this.text.slice(at, child.start) + this.of(child);
      at = child.end;
    }
    return out + this.text.slice(at, node.end);
  }

  special(node) {
    switch (node.type) {
      case "Literal":
        if (typeof node.value !== "number" || Number.isSafeInteger(node.value)) return undefined;
        return `${Math.fround(node.value)} `; // the space: a point may follow
      case "BinaryExpression":
        if (!(node.operator in binary)) return undefined;
        return this.call(binary[node.operator], this.argument(node.left), this.linesBetween(node.left, node.right) + this.argument(node.right));
      case "UnaryExpression":
        return node.operator === "+" ? this.call("number", this.argument(node.argument)) : undefined;
      case "AssignmentExpression":
        return this.assignment(node);
      case "UpdateExpression":
        return this.update(node);
      case "Identifier":
        if (bindsText.has(node.name)) this.refuse(node, "the arithmetic of text that a script makes is not rounded; leave it out");
        return undefined;
      case "Property":
      case "MethodDefinition":
      case "PropertyDefinition":
        // A number as a key is no number of the arithmetic.
        if (node.computed || node.key.type !== "Literal") return undefined;
        return this.text.slice(node.start, node.key.end) + this.after(node.key.end, node, node.value);
      default:
        return undefined;
    }
  }

  after(from, node, value) {
    if (!value) return this.text.slice(from, node.end);
    return this.text.slice(from, value.start) + this.of(value) + this.text.slice(value.end, node.end);
  }

  /** The text as an argument of a call: the parentheses around a comma are not the node's. */
  argument(node) {
    return node.type === "SequenceExpression" ? `(${this.of(node)})` : this.of(node);
  }

  /** The ends of lines between two nodes: lines keep their numbers. */
  linesBetween(before, after) {
    return this.text.slice(before.end, after.start).replace(/[^\n]/g, "");
  }

  call(operation, ...operands) {
    return `${operationsName}.${operation}(${operands.join(", ")})`;
  }

  assignment(node) {
    const operation = binary[node.operator.slice(0, -1)];
    if (operation === undefined) return undefined;
    const { left } = node;
    const operand = this.linesBetween(left, node.right) + this.argument(node.right);
    return this.onPlace(left, (target) => this.call("value", `${target} = ${this.call(operation, target, operand)}`),
      (place) => `${place}.set("${operation}", ${operand})`);
  }

  update(node) {
    const operation = node.operator === "++" ? "next" : "previous";
    return this.onPlace(node.argument,
      (target) => {
        const assigned = `${target} = ${this.call(operation, target)}`;
        return node.prefix ? this.call("value", assigned) : this.call("before", target, assigned);
      },
      (place) => `${place}.${node.prefix ? "set" : "step"}("${operation}")`);
  }

  /** A target of assignment: text that may stand twice, or a place that is evaluated once. */
  onPlace(target, twice, once) {
    if (target.type === "Identifier") return twice(this.of(target));
    const { object, property, computed } = target;
    if (object.type === "Super") this.refuse(target, "write it as an assignment of an operation's result");
    if (property.type === "PrivateIdentifier") {
      if (object.type !== "ThisExpression") this.refuse(target, "write it as an assignment of an operation's result");
      return twice(this.text.slice(target.start, target.end));
    }
    return once(this.call("place", this.argument(object), computed ? this.argument(property) : `"${property.name}"`));
  }
}

/** The nodes below a node, in the order of the text, each once: `{x = 1}` has the key within its value. */
function children(node) {
  const found = Object.values(node).flat().filter((value) => typeof value?.type === "string" && value !== node)
    .sort((a, b) => a.start - b.start || b.end - a.end);
  return found.filter((child, k) => k === 0 || child.start >= found[k - 1].end);
}

function parsed(text, sourceType) {
  try {
    return parse(text, { ecmaVersion: "latest", sourceType, locations: true, allowHashBang: true, allowReturnOutsideFunction: sourceType === "script" });
  } catch (error) {
    if (!(error instanceof SyntaxError) || !error.loc) throw error;
    throw new CannotRound(`line ${error.loc.line}: SyntaxError: ${error.message.replace(/ \(\d+:\d+\)$/, "")}`);
  }
}

/**
 * The text of a script or a module with each operation rounded, line by line as it was.  It names what `scope` has.
 * Errors: CannotRound, with the line, for what is no JavaScript and for what cannot be rounded.
 */
export function inBinary32(text, sourceType = "module") {
  return new Rewriting(text).of(parsed(text, sourceType));
}

/** The value of a module's `export const arithmetic = "..."`; undefined where it has none. */
export function declaredArithmetic(text) {
  for (const { type, declaration } of parsed(text, "module").body) {
    if (type !== "ExportNamedDeclaration" || declaration?.type !== "VariableDeclaration") continue;
    for (const { id, init } of declaration.declarations)
      if (id.type === "Identifier" && id.name === "arithmetic" && init?.type === "Literal") return init.value;
  }
  return undefined;
}
