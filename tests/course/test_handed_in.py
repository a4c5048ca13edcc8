"""Progress files of strangers: what is in order is read, everything else is refused with a reason and costs nobody else anything."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from edulaunch.course.handed_in import MOST_BYTES, Done, read_class
from edulaunch.errors import UnusableInput

GOOD = """[circle]
done = true
attempts = 3
hints = [1]
best_points = 12
points = 12
first = "abc"
last = "abd"

[my_predictions]
square-end = "7.5 5.5"

[my_answers]
remapping = ["b", "a"]
"""


def put(folder: Path, path: str, text: str | bytes) -> None:
    file = folder / path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(text if isinstance(text, bytes) else text.encode())


def test_a_student_is_what_lies_in_the_folder(tmp_path: Path) -> None:
    put(tmp_path, 'anna/course/lessons/my_progress.toml', GOOD)
    put(tmp_path, 'Ada Lovelace_123_assignsubmission_file_/my_progress.toml', GOOD)
    put(tmp_path, 'bert_my_progress.toml', GOOD)
    put(tmp_path, 'carl/notes.txt', 'x')
    standings, refused = read_class(str(tmp_path))
    assert [standing.student for standing in standings] == ['Ada Lovelace', 'anna', 'bert'] and refused == []
    assert standings[0].exercises == {'circle': Done(True, 3, 1, 12.0)}
    assert standings[0].answers == {'remapping': ['b', 'a']}


def test_of_two_files_of_a_student_the_better_counts(tmp_path: Path) -> None:
    put(tmp_path, 'anna/a/my_progress.toml', GOOD)
    put(tmp_path, 'anna/b/my_progress.toml', '[circle]\nattempts = 5\n[follow]\nattempts = 1\n')
    (standing,), _ = read_class(str(tmp_path))
    assert standing.exercises == {'circle': Done(True, 5, 1, 12.0), 'follow': Done(False, 1)}


HOSTILE = {
    'no TOML': ('[circle', 'it is not TOML'),
    'no text': (b'\xff\xfe', 'it is not TOML'),
    'deep': ('a = ' + '[' * 30_000, 'it is not TOML'),
    'large': ('# ' + 'x' * MOST_BYTES, 'it has more than 64 KiB'),
    'another table': ('[circle]\ncolour = 1\n', 'it has a table that check() did not write'),
    'no table': ('circle = 1\n', 'it has a table that check() did not write'),
    'a text for a number': ('[circle]\nattempts = "3"\n', 'attempts in it has the wrong type'),
    'a truth for a number': ('[circle]\nattempts = true\n', 'attempts in it has the wrong type'),
    'too many tries': ('[circle]\nattempts = 999999999\n', 'a number in it is too large or invalid'),
    'less than none': ('[circle]\nattempts = -1\n', 'a number in it is too large or invalid'),
    'no number': ('[circle]\nbest_points = nan\n', 'a number in it is too large or invalid'),
    'endless': ('[circle]\nbest_points = inf\n', 'a number in it is too large or invalid'),
    'odd hints': ('[circle]\nhints = [7]\n', 'its hints are not valid hint levels'),
    'a text for a hint': ('[circle]\nhints = ["1"]\n', 'its hints are not valid hint levels'),
    'odd answers': ('[my_answers]\na = "b"\n', 'its answers were not written by quiz()'),
    'answers that are none': ('my_answers = 1\n', 'its answers were not written by quiz()'),
    'many tables': (''.join(f'[e{number}]\n' for number in range(600)), 'it has more than 500 exercises'),
}


@pytest.mark.parametrize('name', HOSTILE)
def test_an_odd_file_is_refused_and_costs_nobody_else_anything(tmp_path: Path, name: str) -> None:
    text, why = HOSTILE[name]
    put(tmp_path, 'anna/my_progress.toml', GOOD)
    put(tmp_path, 'mallory/my_progress.toml', text)
    standings, refused = read_class(str(tmp_path))
    assert [standing.student for standing in standings] == ['anna']
    assert refused == [('mallory/my_progress.toml', why)]


def test_links_pipes_and_deep_trees_are_not_followed(tmp_path: Path) -> None:
    put(tmp_path, 'outside/my_progress.toml', GOOD)
    folder = tmp_path / 'class'
    put(folder, 'anna/my_progress.toml', GOOD)
    for name in ('linked', 'piped', 'deep', 'looped'):
        (folder / name).mkdir()
    (folder / 'linked' / 'my_progress.toml').symlink_to(tmp_path / 'outside' / 'my_progress.toml')
    (folder / 'away').symlink_to(tmp_path / 'outside')
    (folder / 'looped' / 'again').symlink_to(folder)
    os.mkfifo(folder / 'piped' / 'my_progress.toml')
    put(folder, 'deep/' + 'd/' * 30 + 'my_progress.toml', GOOD)
    standings, refused = read_class(str(folder))
    assert [standing.student for standing in standings] == ['anna']
    assert [item.path for item in refused] == ['linked/my_progress.toml', 'piped/my_progress.toml']
    assert refused[0].why == 'it is a link, and links are not followed'


def test_a_folder_without_any_says_what_to_hand_in(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='there is no my_progress.toml below'):
        read_class(str(tmp_path))
    with pytest.raises(UnusableInput, match='No such file'):
        read_class(str(tmp_path / 'nowhere'))
    (tmp_path / 'class.zip').write_bytes(b'PK')
    with pytest.raises(UnusableInput, match='unpack an archive'):
        read_class(str(tmp_path / 'class.zip'))
