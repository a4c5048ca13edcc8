"""The borrowed parts of osrf_pycommon."""

from __future__ import annotations

from typing import Any

from osrf_pycommon.process_utils import get_loop, which
from osrf_pycommon.terminal_color import ansi, remove_ansi_escape_sequences


def test_one_loop_for_a_process_until_it_is_closed() -> None:
    loop = get_loop()
    assert get_loop() is loop
    loop.close()
    other = get_loop()
    assert other is not loop
    other.close()


def test_programs_are_found_on_the_path_of_the_process(fresh_simulation: Any) -> None:
    assert which('sh') is not None
    fresh_simulation.env['PATH'] = '/nowhere'
    assert which('sh') is None


def test_colours_are_removed() -> None:
    assert remove_ansi_escape_sequences('\x1b[31mred\x1b[0m and \x1b[1;4mbold\x1b[m') == 'red and bold'


def test_colours_and_styles_have_their_sequences() -> None:
    assert (ansi('red'), ansi('redf'), ansi('whiteb'), ansi('boldon'), ansi('reset')) == (
        '\x1b[31m',
        '\x1b[31m',
        '\x1b[47m',
        '\x1b[1m',
        '\x1b[0m',
    )
