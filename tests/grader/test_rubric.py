"""A rubric's order, and its runs.

What the decorator makes of a function.
"""

from __future__ import annotations

from random import Random

import pytest
from edugrade import Check, Evidence, Rubric, Scenario, check
from edugrade.rubrics.catalogue import exercises, find_rubric
from edugrade.submission import exercise_of

from edulaunch.errors import UnusableInput


@check()
def first(run: Evidence) -> None:
    """First"""


@check(needs=[first])
def second(run: Evidence) -> None:
    """Second"""


def make(checks: list[Check]) -> Rubric:
    return Rubric(title='t', scenarios=lambda random: [Scenario('a', {'x': str(random.random())})], checks=checks)


def test_a_check_stands_behind_what_it_needs() -> None:
    with pytest.raises(ValueError, match='second needs first'):
        make([second, first])


def test_two_checks_of_one_name_are_refused() -> None:
    with pytest.raises(ValueError, match='two checks are called first'):
        make([first, first])


def test_the_same_seed_gives_the_same_runs_and_another_seed_others() -> None:
    rubric = make([first, second])
    assert rubric.scenarios(1) == rubric.scenarios(1)
    assert rubric.scenarios(1) != rubric.scenarios(2)
    assert rubric.scenarios(1)[0].arguments['x'] == str(Random(1).random())


@pytest.mark.parametrize('name', ['circle.launch.py', 'circle_launch.py', 'circle.launch.xml', 'circle.launch.yaml', 'circle.py'])
def test_the_exercise_is_found_by_the_files_name(name: str) -> None:
    assert exercise_of(name) == 'circle'


def test_every_rubric_of_the_course_can_be_loaded() -> None:
    names = exercises()
    assert [find_rubric(name)[0] for name in names] == names
    assert {'circle', 'carrot', 'follow', 'large_project', 'water'} <= set(names)


def test_an_unknown_exercise_names_the_nearest() -> None:
    with pytest.raises(UnusableInput) as error:
        find_rubric('cirlce')
    assert (
        error.value.message.startswith('there is no rubric named "cirlce". Available rubrics: ')
        and ' circle, ' in error.value.message
    )
    assert error.value.help is not None
    assert error.value.help.startswith('write --rubric circle, or ')


def test_a_file_without_a_rubric_is_refused(tmp_path: object) -> None:
    file = f'{tmp_path}/empty.py'
    open(file, 'w').close()
    with pytest.raises(UnusableInput, match='defines no RUBRIC'):
        find_rubric('circle', file)


def test_the_first_line_of_the_docstring_is_the_sentence() -> None:
    @check(points=3)
    def there(run: Evidence) -> None:
        """It is there.

        More for the author.
        """

    assert (there.name, there.sentence, there.points, there.needs) == ('there', 'It is there.', 3, ())


def test_a_check_without_a_sentence_is_refused() -> None:
    def silent(run: Evidence) -> None: ...

    with pytest.raises(ValueError, match=r'silent\(\) has no docstring'):
        check()(silent)


def test_negative_points_are_refused() -> None:
    def there(run: Evidence) -> None:
        """There"""

    with pytest.raises(ValueError, match='-1 points'):
        check(points=-1)(there)
