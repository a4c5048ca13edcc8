"""The class Picture: the output of a notebook, with a line of text that describes it."""

from __future__ import annotations

import hashlib
import html
import os
import struct
from base64 import b64encode
from collections.abc import Callable
from importlib import import_module
from typing import Any

from edulaunch.canvas.style import SCALE

SCENE_TYPE = 'application/vnd.edulaunch.scene+json'


class Picture:
    """A drawing of a scene. A notebook shows the image; `repr()` is one line that describes it.

    The output also has a digest of the scene (positions rounded to a micrometre, no pixels), in a format that no front end shows.
    The digest is equal on all machines, so a notebook test (nbval) fails when a picture would look different.
    """

    def __init__(self, draw: Callable[[], bytes], caption: str, scene: Any) -> None:
        self._draw = draw
        self._png: bytes | None = None
        self.caption = caption
        self.scene = scene

    @property
    def digest(self) -> str:
        """Return eight hexadecimal digits for the content of the scene."""
        return digest(self.scene)

    def __repr__(self) -> str:
        return self.caption

    def png(self) -> bytes:
        """Return the image as PNG. The image is drawn only once."""
        if self._png is None:
            self._png = self._draw()
        return self._png

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the image, and its caption as plain text and as alternative text for readers who cannot see the image.

        The output includes HTML, because JupyterLab gives an image/png no alternative text.
        """
        about = png_metadata(self.png(), self.caption)
        look = f'alt="{html.escape(self.caption)}" width="{about["width"]}" height="{about["height"]}"'
        shown = f'<img {look} src="data:image/png;base64,{b64encode(self.png()).decode()}">'
        data = {'text/plain': repr(self), 'text/html': shown, 'image/png': self.png(), **scene_data(self.scene)}
        return data, {'image/png': about}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the image as a PNG file.

        :param path: the path of the file.
        """
        with open(path, 'wb') as file:
            file.write(self.png())


def shown(scene: Any, drawing: str, ax: Any) -> Any:
    """Return a scene as a Picture, or draw it on the axes of the caller and return these axes.

    :param drawing: the name of the module of this package that draws the scene.
    :raises ValueError: when the number of axes is not the number that the scene needs.
    """

    def draw_picture() -> bytes:
        sheet, draw = _drawing(drawing, scene)
        from edulaunch.canvas.sheet import png_of

        return png_of(sheet, lambda axes: draw(scene, axes))

    if ax is None:
        return Picture(draw_picture, scene.caption(), scene)
    sheet, draw = _drawing(drawing, scene)
    from edulaunch.canvas.sheet import our_style

    axes = list(ax.flat) if hasattr(ax, 'flat') else list(ax) if isinstance(ax, (list, tuple)) else [ax]
    needed = len(sheet.boxes)
    if len(axes) != needed:
        raise ValueError(
            f'ax must have {needed} axes, one for each window or tree, not {len(axes)}: use plt.subplots(1, {needed})'
        )
    with our_style():
        draw(scene, axes)
    return ax


def _drawing(module: str, scene: Any) -> tuple[Any, Any]:
    """Return the sheet that a scene needs, and the function that draws the scene on the sheet's axes. Load matplotlib."""
    sheet_of, draw = import_module(f'edulaunch.canvas.{module}').DRAWINGS[type(scene)]
    return sheet_of(scene), draw


def png_metadata(png: bytes, alternative: str, scale: float = SCALE) -> dict[str, Any]:
    """Return the metadata of an image for a notebook: the size on the screen, and the description."""
    width, height = struct.unpack('>II', png[16:24])
    return {'width': round(width / scale), 'height': round(height / scale), 'alt': alternative}


def scene_data(scene: Any) -> dict[str, Any]:
    """Return the output for tests: a digest of the content, with a media type that no front end displays."""
    return {SCENE_TYPE: {'digest': digest(scene)}}


def digest(scene: Any) -> str:
    """Return eight hexadecimal digits for plain data."""
    return hashlib.sha256(repr(rounded(scene)).encode()).hexdigest()[:8]


def rounded(value: Any) -> Any:
    """Return the same data with numbers rounded to six decimals and without negative zeros, so that equal data print equally on
    every machine.
    """
    if isinstance(value, float):
        return round(value, 6) + 0.0
    if isinstance(value, (list, tuple)):
        return [rounded(item) for item in value]
    return value
