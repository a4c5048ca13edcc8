"""Solutions as texts, and changes to them."""

from __future__ import annotations

from pathlib import Path

SOLUTIONS = Path(__file__).parents[3] / 'solutions'
Change = tuple[str, str]
ALL = 'from launch.actions import *\nfrom launch.conditions import *\nfrom launch.substitutions import *\nfrom launch.launch_description_sources import *\n'
ALL += 'from launch import LaunchDescription\nfrom launch_ros.actions import *\nfrom launch_ros.substitutions import FindPackageShare\n'
HEAD = ALL + '\n\ndef generate_launch_description():\n'


def solution(name: str) -> str:
    """The text of a solution, with everything imported that a change may need."""
    return (SOLUTIONS / f'{name}.launch.py').read_text().replace('\n\n\ndef generate', f'\n{ALL}\n\ndef generate', 1)


def changed(text: str, *changes: Change) -> str:
    """A text with changes, each of which must find its place."""
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


def body(lines: str) -> str:
    """A launch file that returns these actions."""
    return f'{HEAD}    return LaunchDescription([{lines}])\n'


def package(*changes: tuple[str, str, str]) -> dict[str, str]:
    """The files of the large project, with changes: (file, old text, new text); an empty old text makes a file anew."""
    folder = SOLUTIONS / 'large_project'
    files = {
        str(path.relative_to(folder)): path.read_text()
        for path in sorted(folder.rglob('*'))
        if path.is_file() and '__pycache__' not in str(path)
    }
    for name, old, new in changes:
        files[name] = changed(files[name], (old, new)) if old else new
    return files
