"""`edulaunch.interact`: a run for each position of a slider."""

from __future__ import annotations

import pytest

pytest.importorskip('ipywidgets')

import edulaunch  # noqa: E402


def test_a_run_for_each_value_and_only_when_the_slider_is_let_go() -> None:
    asked: list[tuple[float, bool]] = []

    def run(radius: float, fast: bool = False) -> None:
        asked.append((radius, fast))

    made = edulaunch.interact(run, radius=(0.5, 2.5))
    slider, box, _ = made.children
    assert slider.continuous_update is False
    slider.value = 2.0
    box.value = True
    assert list(dict.fromkeys(asked)) == [(1.5, False), (2.0, False), (2.0, True)]


def test_a_recording_is_shown_as_its_turtles_and_a_mistake_as_a_sentence(capsys: pytest.CaptureFixture[str]) -> None:
    def run(seconds: float) -> object:
        if seconds > 1:
            raise edulaunch.UnusableInput('too long', help='less')
        return edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=seconds)

    made = edulaunch.interact(run, seconds=(0.5, 1.5))
    made.children[0].value = 0.5
    made.children[0].value = 1.5
    said = capsys.readouterr().out
    assert '/turtlesim1/turtlesim: turtle1 at' in said
    assert 'error: too long' in said
