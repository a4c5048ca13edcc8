"""The sheet: what is drawn where, and its bytes."""

from __future__ import annotations

import struct
import zlib

from edulaunch.canvas import png
from edulaunch.canvas.glyphs import text_width
from edulaunch.canvas.paper import Paper
from edulaunch.canvas.style import mono_width

RED, WHITE = (255, 0, 0), (255, 255, 255)


def pixel(data: bytes, x: int, y: int) -> tuple[int, int, int]:
    """A pixel of one of our PNGs, from the upper left corner."""
    width, _ = png.size(data)
    length = struct.unpack('>I', data[33:37])[0]
    rows = zlib.decompress(data[41 : 41 + length])
    start = y * (3 * width + 1) + 1 + 3 * x
    return (rows[start], rows[start + 1], rows[start + 2])


def test_a_box_stands_where_it_was_put_with_y_up() -> None:
    paper = Paper(20, 10)
    paper.box(0, 0, 5, 5, fill=RED)
    data = paper.png()
    assert png.size(data) == (40, 20)
    assert [pixel(data, 4, 15), pixel(data, 4, 4), pixel(data, 14, 15)] == [RED, WHITE, WHITE]


def test_nothing_is_drawn_outside_of_the_clip() -> None:
    paper = Paper(20, 10, scale=1)
    paper.clip(0, 0, 10, 10)
    paper.box(0, 0, 20, 10, fill=RED)
    paper.clip()
    data = paper.png()
    assert [pixel(data, 5, 5), pixel(data, 15, 5)] == [RED, WHITE]


def test_the_file_holds_nothing_but_the_picture() -> None:
    data = Paper(5, 5).png()
    kinds = []
    position = 8
    while position < len(data):
        length = struct.unpack('>I', data[position : position + 4])[0]
        kinds.append(data[position + 4 : position + 8])
        position += 12 + length
    assert kinds == [b'IHDR', b'IDAT', b'IEND']


def test_layouts_know_the_width_of_monospaced_text_without_the_font() -> None:
    assert abs(text_width('/turtle1/cmd_vel', 11.0, 'mono') - mono_width('/turtle1/cmd_vel', 11.0)) < 0.1


def test_text_leaves_ink_and_returns_its_width() -> None:
    paper = Paper(60, 20, scale=1)
    width = paper.text(5, 5, 'turtle', size=12, halo=WHITE)
    data = paper.png()
    assert 30 < width < 50
    assert any(pixel(data, x, y) != WHITE for x in range(5, 40) for y in range(4, 16))
    assert all(pixel(data, x, y) == WHITE for x in range(50, 60) for y in range(20))
