"""An exact referee for opacity micromaps: indices, baked maps, arrays, and verdicts on others' code.

    index, corners          a point's micro-triangle, and its vertices
    bake, useful_level      the maps of triangles on a texture
    pack, unpack            maps as Vulkan and glTF store them
    build_array             records, data, indices and histograms, with special indices
    draw                    a map as a picture
    prove, validate         judge a function, a library, a file; they need the program `mmverify`

Levels n have 4^n micro-triangles. States are T 0, O 1, UT 2, UO 3: transparent, opaque, and unknown, of which UT counts
as transparent and UO as opaque where unknown is not allowed.
"""
from ._array import Array, build_array
from ._core import version as __version__
from ._index import corners, index
from ._maps import bake, pack, unpack, useful_level
from ._picture import Picture, draw
from ._program import ProgramError
from ._prove import prove
from ._result import Counterexample, LawResult, Result
from ._validate import Finding, validate

__all__ = [
    "Array", "Counterexample", "Finding", "LawResult", "Picture", "ProgramError", "Result", "__version__", "bake",
    "build_array", "corners", "draw", "index", "pack", "prove", "unpack", "useful_level", "validate",
]  # fmt: skip
