# SPDX-License-Identifier: MIT
"""What hodograph raises: every refusal of the library, with its parts."""

from __future__ import annotations


class HodographError(ValueError):
    """Why something could not be done; ``str()`` is a complete sentence.

    Attributes:
        code: the kind of failure, such as ``"not_increasing"``; see foundation/fault.hpp.
        index: which item of the input, counted from 0, or None.
        quantity: the name of the offending quantity, or "".
        value: what it was, or None.
        bound: the limit it violates, or None.
    """

    def __init__(self, sentence: str, code: str = "", index: int | None = None,
                 quantity: str = "", value: float | None = None,
                 bound: float | None = None) -> None:
        super().__init__(sentence, code, index, quantity, value, bound)
        self.code = code
        self.index = index
        self.quantity = quantity
        self.value = value
        self.bound = bound

    def __str__(self) -> str:
        return str(self.args[0])
