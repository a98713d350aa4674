#!/usr/bin/env python3
"""A codec of trees on a pipe:  mmverify gen tree | ./tree.py | mmverify check tree

Reads "CASE encode LEVEL BITS MAP" and "CASE decode LEVEL BITS CODE" lines, bytes in hexadecimal, and writes
"CASE CODE" and "CASE MAP"; or "CASE -" for a code that is nobody's. Codes are those of Succinct Opacity Micromaps,
Algorithms 1 and 2: the tree's bits in pre-order, then from the next whole byte on the leaves' states.
"""
import sys


def unpacked(data, bits):
    """All values of so many bits that the bytes hold, from the least significant bit of each byte on."""
    number = int.from_bytes(data, "little")
    return [number >> bits * k & (1 << bits) - 1 for k in range(8 * len(data) // bits)]


def packed(values, bits):
    number = sum(value << bits * k for k, value in enumerate(values))
    return number.to_bytes((len(values) * bits + 7) // 8, "little")


def encode(states, tree, leaves):
    """Children in the order of the index; four equal ones are a leaf, and so is a micro-triangle."""
    if all(state == states[0] for state in states):
        tree.append(0)
        leaves.append(states[0])
        return
    tree.append(1)
    quarter = len(states) // 4
    for child in range(4):
        encode(states[child * quarter : (child + 1) * quarter], tree, leaves)


def decode(level, bits, code):
    """None where no map is encoded so."""
    nodes, open_nodes, tree = unpacked(code, 1), [level], []
    while open_nodes:
        if len(tree) == len(nodes):
            return None
        depth = open_nodes.pop()
        tree.append((nodes[len(tree)], depth))
        if tree[-1][0]:
            if depth == 0:
                return None
            open_nodes += [depth - 1] * 4
    values = unpacked(code[(len(tree) + 7) // 8 :], bits)
    leaves = [depth for internal, depth in tree if not internal]
    if len(values) < len(leaves):
        return None
    states = [state for depth, value in zip(leaves, values) for state in [value] * 4**depth]
    # Unused bits, bytes too many and four equal leaves all encode to something else.
    return packed(states, bits) if encoded(states, bits) == code else None


def encoded(states, bits):
    tree, leaves = [], []
    encode(states, tree, leaves)
    return packed(tree, 1) + packed(leaves, bits)


for line in sys.stdin:
    if line.startswith("#"):  # the heading says which cases these are; `check` compares it
        print(line, end="")
        continue
    case, what, level, bits, data = line.split()
    level, bits, data = int(level), int(bits), b"" if data == "-" else bytes.fromhex(data)
    if what == "encode":
        answer = encoded(unpacked(data, bits)[: 4**level], bits)
    else:
        answer = decode(level, bits, data)
    print(case, "-" if answer is None else answer.hex())
