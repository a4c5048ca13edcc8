"""What failures say."""

from __future__ import annotations

from edugrade import Failure, Mismatch, Missing


def test_missing_offers_the_nearest_name() -> None:
    failure = Missing('the argument "circle_radius"', name='circle_radius', among=['circle_radious', 'x'], try_='declare it')
    assert failure.rationale == 'the argument "circle_radius" is missing'
    assert failure.seen == 'circle_radious, x'
    failure.correct(["DeclareLaunchArgument('circle_radious')"])
    assert failure.try_ == 'write "circle_radius" instead of "circle_radious"'


def test_a_name_that_the_student_did_not_write_is_no_slip() -> None:
    failure = Missing('the topic /turtle1/pose', name='/turtle1/pose', among=['/turtle1/poses'], try_='start it')
    failure.correct(['Node(package="turtlesim", executable="turtlesim_node")'])
    assert failure.try_ == 'start it'


def test_another_name_in_a_full_name_is_no_slip() -> None:
    for name, known in (('/hall/listener', '/hall/talker'), ('/kitchen/listener', '/hall/listener'), ('/late/sim', '/sim')):
        failure = Missing(f'the node {name}', name=name, among=[known], try_='start it')
        failure.correct(['hall talker listener sim'])
        assert failure.try_ == 'start it'


def test_any_failure_may_know_a_misspelt_name() -> None:
    failure = Failure('the parent is wrong', name='turtle1', among=['turtel1'], try_='look at the tree')
    failure.correct(["'--frame-id', 'turtel1'"])
    assert failure.try_ == 'write "turtle1" instead of "turtel1"'


def test_missing_without_anything_near_says_what_to_try() -> None:
    failure = Missing('the node a', name='alpha', among=[], try_='start it')
    assert (failure.seen, failure.try_) == (None, 'start it')


def test_mismatch_shows_both_values_in_full() -> None:
    failure = Mismatch('the radius', 0.5, 'x' * 100, where=('a.launch.py', 3))
    assert (failure.expected, failure.seen, failure.where) == ('0.5', 'x' * 100, ('a.launch.py', 3))


def test_a_missing_value_stays_absent() -> None:
    assert Failure('no').expected is None
