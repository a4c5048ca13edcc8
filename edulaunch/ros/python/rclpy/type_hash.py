"""The hash of a type."""

from __future__ import annotations

HASH_SIZE = 32


class TypeHash:
    """The hash of a type: a version, and 32 bytes.

    The string form is `RIHS01_...`, or INVALID if the version is missing or the length is wrong.

    :raises AssertionError: for a version that is not an int, or a value that is not bytes.
    """

    __slots__ = ('_version', '_value')

    def __init__(self, version: int = -1, value: bytes = bytes(HASH_SIZE)) -> None:
        self.version = version
        self.value = value

    @property
    def version(self) -> int:
        """The version of the hash algorithm, or -1 if it is missing."""
        return self._version

    @version.setter
    def version(self, value: int) -> None:
        assert isinstance(value, int)
        self._version = value

    @property
    def value(self) -> bytes:
        """The bytes of the hash."""
        return self._value

    @value.setter
    def value(self, value: bytes) -> None:
        assert isinstance(value, bytes)
        self._value = value

    def __str__(self) -> str:
        if self._version <= 0 or len(self._value) != HASH_SIZE:
            return 'INVALID'
        return f'RIHS{self._version:02}_{self._value.hex()}'

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TypeHash) and (self._version, self._value) == (other._version, other._value)

    __hash__ = None  # type: ignore[assignment]
