#!/usr/bin/env python3
"""A baker on a pipe:  mmverify gen bake | ./bake.py | mmverify check bake --law bake.conservative

Reads "CASE LEVEL BITS TEXTURE" lines, and writes "CASE MAP", bytes in hexadecimal. TEXTURE is a list of KEY=VALUE:
texels=TYPE:WIDTHxHEIGHT:DIGITS, wrap=U:V, border=DIGITS, filter=nearest, mips=N, factor=F, vertex=F, cutoff=N/D or
blend, margin=TEXELS, uv=U0:V0:U1:V1:U2:V2, floats as C's %a; what is as usual is left out.

This baker looks at no triangle: a map is known where the whole texture is on one side of the cutoff. It is
conservative, and far from tight.
"""
import struct
import sys
from fractions import Fraction

DIGITS = {"u8": 2, "u16": 4, "f32": 8}


def alpha(kind, digits):
    if kind == "f32":
        return Fraction(struct.unpack(">f", bytes.fromhex(digits))[0])
    return Fraction(int(digits, 16), 256 ** (len(digits) // 2) - 1)


def bake(level, bits, text):
    case = dict(part.split("=", 1) for part in text.split(","))
    kind, _, digits = case["texels"].split(":")
    step = DIGITS[kind]
    texels = {digits[k : k + step] for k in range(0, len(digits), step)}
    if "border" in case:
        texels.add(case["border"])
    factor = Fraction(float.fromhex(case.get("factor", "1"))) * Fraction(float.fromhex(case.get("vertex", "1")))
    values = [alpha(kind, texel) * factor for texel in texels]
    if case["cutoff"] == "blend":
        opaque, transparent = min(values) >= 1, max(values) <= 0
    else:
        opaque, transparent = min(values) >= Fraction(case["cutoff"]), max(values) < Fraction(case["cutoff"])
    state = 1 if opaque else 0 if transparent else 3 if bits == 2 else 1
    return sum(state << bits * k for k in range(4**level)).to_bytes((bits * 4**level + 7) // 8, "little")


for line in sys.stdin:
    if line.startswith("#"):  # the heading says which cases these are; `check` compares it
        print(line, end="")
        continue
    case, level, bits, texture = line.split()
    print(case, bake(int(level), int(bits), texture).hex())
