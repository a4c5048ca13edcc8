"""The states of a lifecycle node, its transitions, and where each callback's result leads."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
import rclpy.lifecycle.state_machine as machine
from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle.managed_entity import ManagedEntity, SimpleManagedEntity
from rclpy.lifecycle.state_machine import STATES, Life, TransitionCallbackReturn, all_transitions, transition_from

OK, FAILURE, ERROR = TransitionCallbackReturn.__members__.values()
GRAPH = """
10 transition_success configuring inactive
11 transition_failure configuring unconfigured
12 transition_error configuring errorprocessing
20 transition_success cleaningup unconfigured
21 transition_failure cleaningup inactive
22 transition_error cleaningup errorprocessing
30 transition_success activating active
31 transition_failure activating inactive
32 transition_error activating errorprocessing
40 transition_success deactivating inactive
41 transition_failure deactivating active
42 transition_error deactivating errorprocessing
50 transition_success shuttingdown finalized
51 transition_failure shuttingdown finalized
52 transition_error shuttingdown errorprocessing
60 transition_success errorprocessing unconfigured
61 transition_failure errorprocessing finalized
62 transition_error errorprocessing finalized
1 configure unconfigured configuring
2 cleanup inactive cleaningup
3 activate inactive activating
4 deactivate active deactivating
5 shutdown unconfigured shuttingdown
6 shutdown inactive shuttingdown
7 shutdown active shuttingdown
"""
"""As ROS 2's design of managed nodes has them, with the numbers of lifecycle_msgs."""


def test_the_graph_is_that_of_ros() -> None:
    assert sorted(all_transitions()) == sorted(
        (int(number), *words) for number, *words in map(str.split, GRAPH.strip().splitlines())
    )
    assert [(state.label, state.state_id) for state in STATES.values()] == [
        ('unknown', 0),
        ('unconfigured', 1),
        ('inactive', 2),
        ('active', 3),
        ('finalized', 4),
        ('configuring', 10),
        ('cleaningup', 11),
        ('shuttingdown', 12),
        ('activating', 13),
        ('deactivating', 14),
        ('errorprocessing', 15),
    ]
    assert [(one.name, one.value, one.to_label()) for one in (OK, FAILURE, ERROR)] == [
        ('SUCCESS', 97, 'transition_success'),
        ('FAILURE', 98, 'transition_failure'),
        ('ERROR', 99, 'transition_error'),
    ]


@pytest.mark.parametrize(
    ('state', 'wanted', 'number'),
    [
        ('inactive', 3, 3),
        ('inactive', 'activate', 3),
        ('active', 'shutdown', 7),
        ('active', 5, None),
        ('finalized', 'configure', None),
    ],
)
def test_a_transition_is_asked_for_by_number_or_label(state: str, wanted: int | str, number: int | None) -> None:
    found = transition_from(state, wanted)
    assert (None if found is None else found.number) == number


class Managed:
    """A node whose callbacks answer as the test says."""

    def __init__(self, **answers: Any) -> None:
        self.answers, self.asked, self.events = answers, list[tuple[str, str]](), list[str]()
        self.life = Life(self)  # type: ignore[arg-type]
        self.life.services = SimpleNamespace(publish_event=lambda start, goal: self.events.append(f'{start.label} {goal.label}'))  # type: ignore[assignment]

    def __getattr__(self, name: str) -> Any:
        if not name.startswith('on_'):
            raise AttributeError(name)

        def callback(state: Any) -> Any:
            self.asked.append((name, state.label))
            answer = self.answers.get(name, OK)
            if isinstance(answer, Exception):
                raise answer
            return answer

        return callback

    def get_fully_qualified_name(self) -> str:
        return '/ns/n'


@pytest.mark.parametrize(
    ('answers', 'result', 'asked', 'states'),
    [
        ({}, OK, [('on_configure', 'unconfigured')], ['configuring', 'inactive']),
        ({'on_configure': FAILURE}, FAILURE, [('on_configure', 'unconfigured')], ['configuring', 'unconfigured']),
        (
            {'on_configure': ERROR},
            ERROR,
            [('on_configure', 'unconfigured'), ('on_error', 'unconfigured')],
            ['configuring', 'errorprocessing', 'unconfigured'],
        ),
        (
            {'on_configure': ERROR, 'on_error': FAILURE},
            ERROR,
            [('on_configure', 'unconfigured'), ('on_error', 'unconfigured')],
            ['configuring', 'errorprocessing', 'finalized'],
        ),
    ],
)
def test_a_result_decides_where_a_transition_leads(answers: Any, result: Any, asked: Any, states: list[str]) -> None:
    node = Managed(**answers)
    assert node.life.trigger('configure') is result
    assert node.asked == asked
    assert node.events == [f'{start} {goal}' for start, goal in zip(['unconfigured', *states], states, strict=False)]
    assert node.life.state.label == states[-1]


def test_an_exception_is_an_error_and_a_fact(monkeypatch: pytest.MonkeyPatch) -> None:
    facts: list[Any] = []
    process = SimpleNamespace(fact=lambda *row: facts.append(row))
    monkeypatch.setattr(
        machine, 'core_of', lambda node: SimpleNamespace(process=process, entry=SimpleNamespace(index=4), full_name='/ns/n')
    )
    assert Managed(on_configure=KeyError('x')).life.trigger(1) is ERROR
    with pytest.raises(AttributeError, match='to_label'):
        Managed(on_configure=None).life.trigger(1)
    about = {'node': '/ns/n', 'callback': 'on_configure'}
    key = ('transition failed', (4, 'on_configure'))
    assert facts == [(*key, {**about, 'raised': "KeyError: 'x'"}), (*key, {**about, 'returned': 'None'})]


def test_a_transition_that_is_not_there_is_refused_with_those_that_are() -> None:
    node = Managed()
    with pytest.raises(RCLError, match='Transition is not registered') as caught:
        node.life.trigger('activate')
    facts: Any = caught.value.edulaunch_facts  # type: ignore[attr-defined]
    assert facts == {
        'about': 'programs.no-transition',
        'node': '/ns/n',
        'state': 'unconfigured',
        'possible': ['1 (configure)', '5 (shutdown)'],
        'transition': 'activate',
    }
    assert (node.asked, node.events) == ([], [])


@pytest.mark.parametrize(('way', 'asked'), [([], 'on_shutdown'), ([1], 'on_shutdown'), ([1, 3], 'on_shutdown')])
def test_a_node_shuts_down_from_every_state_but_the_last(way: list[int], asked: str) -> None:
    node = Managed()
    for number in way:
        node.life.trigger(number)
    assert node.life.trigger_shutdown() is OK
    assert (node.asked[-1][0], node.life.state.label) == (asked, 'finalized')
    with pytest.raises(RCLError, match='Shutdown transtion not possible'):
        node.life.trigger_shutdown()


def test_parts_of_a_node_are_told_until_one_does_not_succeed() -> None:
    told: list[int] = []

    class Part(ManagedEntity):
        def __init__(self, number: int, answer: Any) -> None:
            self.number, self.answer = number, answer

        def on_activate(self, state: Any) -> Any:
            told.append(self.number)
            return self.answer

    life = Life(None)  # type: ignore[arg-type]
    assert life.tell_entities('on_activate', STATES['inactive']) is OK
    life.entities = [Part(1, OK), Part(2, FAILURE), Part(3, OK)]
    assert life.tell_entities('on_activate', STATES['inactive']) is FAILURE
    assert told == [1, 2]
    for callback in ('on_configure', 'on_cleanup', 'on_shutdown', 'on_deactivate', 'on_error'):
        assert life.tell_entities(callback, STATES['inactive']) is OK


def test_a_simple_part_works_only_while_it_is_active() -> None:
    done: list[str] = []

    class Part(SimpleManagedEntity):
        @SimpleManagedEntity.when_enabled
        def plain(self, word: str) -> None:
            done.append(word)

        @SimpleManagedEntity.when_enabled(when_not_enabled=lambda: done.append('not now'))
        def other(self, *, word: str) -> None:
            done.append(word)

    part = Part()
    assert part.is_activated is False
    part.plain('a')
    part.other(word='b')
    assert (part.on_activate(STATES['inactive']), part.is_activated) == (OK, True)
    part.plain('c')
    part.other(word='d')
    assert (part.on_deactivate(STATES['active']), part.is_activated) == (OK, False)
    part.plain('e')
    assert done == ['not now', 'c', 'd']
    assert Part.plain.__name__ == 'plain'


def test_programs_can_read_the_state_machine() -> None:
    life = Life(SimpleNamespace())  # type: ignore[arg-type]
    life.state = STATES['inactive']
    seen = machine.StateMachineView(life)
    assert (seen.current_state, seen.available_states[-1]) == ((2, 'inactive'), (15, 'errorprocessing'))
    assert seen.transition_graph[:2] == [
        (1, 'configure', 1, 'unconfigured', 10, 'configuring'),
        (10, 'transition_success', 10, 'configuring', 2, 'inactive'),
    ]
    assert [one[1] for one in seen.available_transitions] == ['cleanup', 'activate', 'shutdown']
