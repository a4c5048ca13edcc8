"""Checking a launch file while it is typed, against what Python takes to parse the same file."""

from __future__ import annotations

import ast
import time
from contextlib import suppress
from pathlib import Path

from edulaunch.advice.texts import Around, check

SOLUTIONS = Path(__file__).parents[2] / 'solutions'
TIMES = 7
MISTAKEN = {"'turtlesim'": "'turtlesm'", 'executable=': 'exectable=', 'LogInfo(': 'LogInfo(mgs='}
"""What is written wrong in the second figure."""


def measure() -> dict[str, float]:
    """The sum over all solutions that are launch files in Python; of each the best of seven, taken in turns with parsing."""
    files = [(path, path.read_text(encoding='utf-8')) for path in sorted(SOLUTIONS.rglob('*.launch.py'))]
    healthy = _both(files)
    mistaken = _both([(path, _with_mistakes(text)) for path, text in files])
    return {
        'launch files': len(files),
        'a check of a healthy one (ms)': healthy[0] * 1e3 / len(files),
        'a check of a mistaken one (ms)': mistaken[0] * 1e3 / len(files),
        'checking / parsing, healthy': healthy[0] / healthy[1],
        'checking / parsing, mistaken': mistaken[0] / mistaken[1],
    }


def _with_mistakes(text: str) -> str:
    for old, new in MISTAKEN.items():
        text = text.replace(old, new, 1)
    return text


def _both(files: list[tuple[Path, str]]) -> tuple[float, float]:
    """Seconds for checking and for parsing all files."""
    checking = parsing = 0.0
    for path, text in files:
        around = Around(str(path))
        check(text, str(path), around)
        pairs = [(_taken(lambda: check(text, str(path), around)), _taken(lambda: _parse(text))) for _ in range(TIMES)]  # noqa: B023
        checking += min(pair[0] for pair in pairs)
        parsing += min(pair[1] for pair in pairs)
    return checking, parsing


def _parse(text: str) -> None:
    with suppress(SyntaxError):
        ast.parse(text)


def _taken(act) -> float:  # type: ignore[no-untyped-def]
    began = time.process_time()
    act()
    return time.process_time() - began


if __name__ == '__main__':
    for name, figure in measure().items():
        print(f'{name}: {figure:.4g}')
