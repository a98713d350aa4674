#!/usr/bin/env python3
"""Judges an index function by mmverify_vectors.bin: put yours in the place of index_of().

usage: mmverify vectors -o DIR && read.py DIR/mmverify_vectors.bin
Prints how many answers are those of each dialect, and the first that is not exact; exit code 1 where neither has all."""
import struct
import sys
from fractions import Fraction


def sections(file):
    """(family, section) to (bytes of a record, bytes), by the table of contents."""
    magic, version, entries, at, size = struct.unpack_from("<8s4I", file)
    if magic != b"MMVECTOR" or version != 2 or size != len(file):
        sys.exit("no vectors of mmverify, or not all of them")
    found = {}
    for k in range(entries if at + 64 * entries <= len(file) else 0):
        family, section, _, record, records, start = struct.unpack_from("<16s16s4I", file, at + 64 * k)
        name = tuple(text.rstrip(b"\0").decode() for text in (family, section))
        if record == 0 or start + record * records > len(file):
            sys.exit(f"{name}: it does not say where its records are")
        found[name] = record, file[start : start + record * records]
    return found


def spread(x):
    return sum((x >> k & 1) << 2 * k for k in range(16))


def index_of(level, u, v):
    """The reference code of VK_EXT_opacity_micromap, on exact numbers."""
    n = 1 << level
    u, v = (min(max(Fraction(x), 0), 1) * n for x in (u, v))
    iu, iv = int(u), int(v)
    upper = u - iu + v - iv >= 1
    iu, iv = min(iu, n - 1), min(iv, n - 1)
    s = iu + iv
    iu -= max(s - n + 1, 0)
    iw = ~(iu + iv) - (upper and s < n - 1)
    b0 = ~(iu ^ iw) & n - 1
    t = f = (iu ^ iv) & b0
    for shift in 1, 2, 4, 8:
        f ^= f >> shift
    return spread(b0) | spread((f ^ iu) & ~b0 & n - 1 | t) << 1


(path,) = sys.argv[1:] or sys.exit("usage: read.py mmverify_vectors.bin")
parts = sections(open(path, "rb").read())
size, points = parts["index", "points"]
abouts = [text.rstrip(b"\0").decode() for (text,) in struct.iter_unpack("64s", parts["index", "about"][1])]
total, exact, published, prose, inside, first = len(points) // size, 0, 0, 0, 0, ""
for at in range(0, total * size, size):  # a later version may add columns at a record's end
    about, level, u, v, on, gap, right, in_floats, said, given = struct.unpack_from("<IIffIf4I", points, at)
    answer = index_of(level, u, v)
    exact += answer == right
    published += answer == in_floats
    inside += given  # 0: there is no such answer; else it may be any number, 2^32 - 1, too
    prose += given and answer == said
    if answer != right and not first:
        first = f"first: level {level}, u {u.hex()}, v {v.hex()}: {abouts[about]}"
print(f"published: {published} of {total}, exact: {exact} of {total}, prose: {prose} of {inside}")
if first:
    print(first)
sys.exit(total == 0 or total not in (exact, published))
