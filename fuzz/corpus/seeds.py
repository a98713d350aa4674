"""The argument of corpus/make_*.py, and how their seeds become files."""
import pathlib
import sys


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
