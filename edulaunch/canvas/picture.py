"""A picture: what a notebook shows, with a line of text that says the same."""
from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from typing import Any


class Picture:
    """A drawing of a scene. A notebook shows the image; `repr()` is one line with a digest of the scene.

    The digest covers what is shown (positions to a micrometre), not pixels: it is equal on all machines, and a notebook test
    that compares text notices when a picture would look different.
    """

    def __init__(self, draw: Callable[[], bytes], caption: str, scene: Any) -> None:
        self._draw = draw
        self._png: bytes | None = None
        self.caption = caption
        self.scene = scene

    @property
    def digest(self) -> str:
        """Eight hexadecimal digits for what the scene shows."""
        return hashlib.sha256(repr(rounded(self.scene)).encode()).hexdigest()[:8]

    def __repr__(self) -> str:
        return f'{self.caption} [scene {self.digest}]'

    def png(self) -> bytes:
        """The image as PNG, drawn once."""
        if self._png is None:
            self._png = self._draw()
        return self._png

    def _repr_png_(self) -> bytes:
        return self.png()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the image as a PNG file."""
        with open(path, 'wb') as file:
            file.write(self.png())


def rounded(value: Any) -> Any:
    """The same data with numbers to six decimals and without negative zeros, so that it prints alike everywhere."""
    if isinstance(value, float):
        return round(value, 6) + 0.0
    if isinstance(value, (list, tuple)):
        return [rounded(item) for item in value]
    return value
