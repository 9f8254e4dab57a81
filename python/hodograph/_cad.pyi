# SPDX-License-Identifier: MIT
# Written by tools/make_stubs from the built package; do not edit.

import os
from typing import Any, ClassVar

from ._core import Sweep

class StepModel:
    @property
    def degree_along(self) -> int: ...
    @property
    def degree_round(self) -> int: ...
    @property
    def faces(self) -> int: ...
    @property
    def solid(self) -> bool: ...
    @property
    def text(self) -> str: ...
    def __copy__(self) -> StepModel: ...
    def __deepcopy__(self, memo: dict[str, Any]) -> StepModel: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __repr__(self) -> str: ...

largest_cad_degree: int

def save_step(
    sweep: Sweep,
    file: str | os.PathLike[str],
    *,
    name: str = '',
    length_unit: str = '',
    caps: bool = True,
) -> StepModel: ...
def step_of(
    sweep: Sweep,
    *,
    name: str = '',
    length_unit: str = '',
    caps: bool = True,
) -> StepModel: ...
