"""The hash of a type."""
from __future__ import annotations


class TypeHash:
    """The hash of a type, as `RIHS01_...`."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.version = 1
        self.value = bytes.fromhex(text.partition('_')[2])

    def __str__(self) -> str:
        return self.text

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TypeHash) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)
