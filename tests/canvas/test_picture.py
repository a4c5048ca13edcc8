"""What a notebook gets from a picture."""

from __future__ import annotations

from pathlib import Path

from edulaunch.canvas.picture import Picture, digest
from edulaunch.canvas.sheet import Sheet, png_of

SHEET = png_of(Sheet(30, 20, []), lambda axes: None)


def test_the_repr_is_the_caption() -> None:
    assert repr(Picture(lambda: b'', 'one turtle', (1.0, 'turtle1'))) == 'one turtle'


def test_the_digest_sees_a_micrometre_but_no_rounding_noise() -> None:
    assert digest([0.1 + 0.2, -0.0]) == digest((0.3, 0.0))
    assert digest([0.3]) != digest([0.300001])


def test_the_image_is_drawn_once_and_only_when_it_is_wanted() -> None:
    drawn = []
    picture = Picture(lambda: drawn.append(1) or SHEET, 'a sheet', ())  # type: ignore[func-returns-value]
    assert (repr(picture).startswith('a sheet'), drawn) == (True, [])
    picture.png()
    picture.png()
    assert drawn == [1]


def test_the_bundle_has_image_text_size_and_alternative_text() -> None:
    data, metadata = Picture(lambda: SHEET, 'a sheet', ())._repr_mimebundle_()
    assert data['text/plain'] == 'a sheet' and data['image/png'].startswith(b'\x89PNG')
    assert metadata == {'image/png': {'width': 30, 'height': 20, 'alt': 'a sheet'}}


def test_saving_writes_the_same_bytes(tmp_path: Path) -> None:
    picture = Picture(lambda: SHEET, '', ())
    picture.save(tmp_path / 'sheet.png')
    assert (tmp_path / 'sheet.png').read_bytes() == picture.png()
