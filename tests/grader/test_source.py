"""Where the grader points in a submission."""

from __future__ import annotations

from edugrade.source import SubmittedText

TEXT = """from launch import LaunchDescription


def generate_launch_description():
    # TODO 1: declare
    return LaunchDescription([
        Node(),  # TODO is mentioned
        #TODO 2
    ])
"""


def test_a_missing_action_belongs_into_the_launch_description() -> None:
    assert SubmittedText('a', TEXT).place == ('a', 6)


def test_without_a_launch_description_the_function_is_the_place() -> None:
    assert SubmittedText('a', 'x = 1\ndef generate_launch_description():\n    pass\n').place == ('a', 2)


def test_without_a_function_there_is_only_the_file() -> None:
    assert SubmittedText('a', 'x = 1\n').place == ('a', None)


def test_gaps_are_comments_that_start_with_todo() -> None:
    assert SubmittedText('a', TEXT).gaps == [('a', 5, '# TODO 1: declare'), ('a', 8, '#TODO 2')]
