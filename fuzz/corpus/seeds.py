"""The argument of corpus/make_*.py, how their seeds become files, and inputs of a share."""
import pathlib
import sys


def number(data):
    """A number that all bytes of an input determine: fuzz/share.hpp."""
    joined = 0x811C9DC5
    for byte in data:
        joined = (joined ^ byte) * 0x01000193 & 0xFFFFFFFF
    return joined ^ joined >> 16


def in_share(data, share):
    """The input, ended by bytes that put it among the 1/share of all inputs that a harness takes for what is slow."""
    ends = (end.to_bytes(length, "little") for length in range(3) for end in range(256**length))
    return next(data + end for end in ends if number(data + end) % share == 0)


def write(corpora):
    """Bytes by harness and by the seed's name, into FOLDER/HARNESS/NAME; FOLDER is the program's argument."""
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(f"usage: {sys.argv[0]} FOLDER; fuzz/write-seeds FOLDER writes those of all harnesses", file=sys.stderr)
        sys.exit(2)
    for harness, seeds in corpora.items():
        folder = pathlib.Path(sys.argv[1], harness)
        folder.mkdir(parents=True, exist_ok=True)
        for name, data in seeds.items():
            (folder / name).write_bytes(data)
