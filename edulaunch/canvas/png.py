"""PNG bytes of an array of pixels: the same bytes for the same pixels, with nothing else in them."""

from __future__ import annotations

import struct
import zlib
from typing import Any

SIGNATURE = b'\x89PNG\r\n\x1a\n'
LEVEL = 4
"""Of compression: higher ones take twice the time for a few per cent."""


def encode(pixels: Any) -> bytes:
    """PNG of an array of shape (height, width, 3 or more) with bytes red, green, blue; further channels are left out."""
    import numpy as np

    height, width = pixels.shape[:2]
    rows = np.zeros((height, 1 + 3 * width), dtype=np.uint8)  # each row begins with its filter: 0, none
    rows[:, 1:] = pixels[:, :, :3].reshape(height, 3 * width)
    header = struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)
    data = zlib.compress(rows.tobytes(), LEVEL)
    return SIGNATURE + _chunk(b'IHDR', header) + _chunk(b'IDAT', data) + _chunk(b'IEND', b'')


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))


def size(png: bytes) -> tuple[int, int]:
    """Width and height in pixels of a PNG."""
    width, height = struct.unpack('>II', png[16:24])
    return width, height
