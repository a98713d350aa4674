"""The library behind arrays; its users are the modules beside it."""
from typing import List, Optional, Tuple, Union

import numpy as np

version: str

def index(level: int, u: np.ndarray, v: np.ndarray) -> np.ndarray: ...
def corners(level: int, index: np.ndarray) -> np.ndarray: ...
def pack(codes: np.ndarray, states: int) -> np.ndarray: ...
def unpack(packed: np.ndarray, count: int, states: int) -> np.ndarray: ...
def useful_levels(uv: np.ndarray, width: int, height: int, limit: int) -> np.ndarray: ...
def bake(
    mips: List[np.ndarray],
    uv: np.ndarray,
    levels: np.ndarray,
    states: int,
    packed: bool,
    threads: int,
    cutoff: Union[Tuple[int, int], float, None],
    wrap: Tuple[int, int],
    nearest: bool,
    border: float,
    factors: Tuple[float, float],
    margin: float,
) -> np.ndarray: ...
def build(
    packed: List[np.ndarray],
    levels: np.ndarray,
    states: int,
    api: int,
    encoding: int,
    special: bool,
    share: bool,
    bound: int,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, Optional[np.ndarray]]: ...
