"""A comparison of two plans or runs: its colours tell the two sides apart for everyone, and none of them means an error."""

from __future__ import annotations

import colorsys
import re
from itertools import combinations

import pytest

from edulaunch.advice.explaining import tree
from edulaunch.canvas import draw_system
from edulaunch.desk.view import compared
from tests.desk.view.test_page import contrast

BLIND = {  # linear red, green and blue as somebody without the cones for red, or for green, sees them (Viénot, Brettel, Mollon 1999)
    'protan': ((0.11238, 0.88762, 0.0), (0.11238, 0.88762, 0.0), (0.00401, -0.00401, 1.0)),
    'deutan': ((0.29275, 0.70725, 0.0), (0.29275, 0.70725, 0.0), (-0.02234, 0.02234, 1.0)),
}
LIGHT, DARK = (dict(re.findall(r'--(\w+): (#\w+)', part)) for part in compared.STYLE.split('@media')[:2])
TREE = dict(re.findall(r'\.(added|gone|changed)\{border-left:[.\w]+ \w+ (#\w+)', tree.STYLE))
STILL = {sign: f'#{"".join(f"{part:02x}" for part in colour)}' for sign, colour in draw_system.SIGNS.items() if sign}
PALETTES = {'light': LIGHT, 'dark': DARK, 'tree': TREE, 'still': STILL}


def parts(colour: str) -> list[float]:
    digits = colour[1:] if len(colour) == 7 else ''.join(2 * digit for digit in colour[1:])
    return [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]


def seen(colour: str, rows: tuple[tuple[float, ...], ...]) -> list[float]:
    linear = [part**2.2 for part in parts(colour)]
    return [max(0.0, sum(a * b for a, b in zip(row, linear, strict=True))) ** (1 / 2.2) for row in rows]


@pytest.mark.parametrize('name', PALETTES)
def test_no_difference_is_red(name: str) -> None:
    signs = {key: colour for key, colour in PALETTES[name].items() if key not in ('ink', 'paper')}
    assert len(signs) == 3
    for key, colour in signs.items():
        hue, _, saturation = colorsys.rgb_to_hls(*parts(colour))
        assert saturation < 0.2 or 20 / 360 < hue < 340 / 360, f'{key} is red: {colour}'


@pytest.mark.parametrize('name', PALETTES)
@pytest.mark.parametrize('rows', BLIND.values(), ids=BLIND)
def test_colour_blind_people_tell_the_two_sides_apart(name: str, rows: tuple[tuple[float, ...], ...]) -> None:
    signs = [colour for key, colour in PALETTES[name].items() if key not in ('ink', 'paper')]
    for one, other in combinations(signs, 2):
        distance = sum((a - b) ** 2 for a, b in zip(seen(one, rows), seen(other, rows), strict=True)) ** 0.5
        assert distance > 0.2, f'{one} and {other}'


@pytest.mark.parametrize('look', [LIGHT, DARK], ids=['light', 'dark'])
def test_the_words_of_a_difference_have_contrast(look: dict[str, str]) -> None:
    whole = {key: f'#{"".join(f"{round(part * 255):02x}" for part in parts(colour))}' for key, colour in look.items()}
    assert min(contrast(whole[key], whole['paper']) for key in ('new', 'gone', 'changed')) >= 4.5


def test_borders_of_the_tree_are_seen_on_both_grounds_and_differ_by_their_line() -> None:
    assert min(contrast(colour, ground) for colour in TREE.values() for ground in ('#ffffff', '#111111')) >= 3.0
    assert len(set(re.findall(r'(?:added|gone|changed)\{border-left:[.\w]+ (\w+)', tree.STYLE))) == 3


def test_a_terminal_shows_no_difference_in_red() -> None:
    assert set(tree.SIGNS) == {'+', '-', '~'} and '31' not in tree.SIGNS.values()
    assert len(set(tree.SIGNS.values())) == 3
