"""Names that rclpy itself needs of a node: what happens when a program gives them another meaning, as with the real rclpy 7.1.6."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import rclpy
from rclpy.impl.own_names import private_names
from rclpy.node import Node

from edulaunch.engine.facts import facts_of

from .conftest import Ros, World

Program = Callable[[Callable[[], object]], None]
METHOD = "'method' object "


@pytest.fixture
def program(ros: Ros, world: World) -> Program:
    """Run a function to its end as a program."""

    def run(body: Callable[[], object]) -> None:
        def whole() -> None:
            body()
            world.say('done')

        assert ros(whole) == ['done']

    return run


def robot(name: str) -> type[Node]:
    return type('Robot', (Node,), {name: lambda self, *args: None})


@pytest.mark.parametrize(
    ('name', 'text'),
    [
        ('handle', METHOD + 'does not support the context manager protocol'),
        ('default_callback_group', "'function' object has no attribute 'add_entity'"),
        ('executor', "'function' object has no attribute 'wake'"),
    ],
)
def test_what_a_node_needs_when_it_is_made(program: Program, name: str, text: str) -> None:
    @program
    def body() -> None:
        with pytest.raises((TypeError, AttributeError), match=text) as caught:
            robot(name)('robot')
        assert facts_of(caught.value) == {'about': 'programs.own-name', 'node': 'Robot', 'attribute': name}


def test_what_a_timer_needs(program: Program) -> None:
    @program
    def body() -> None:
        node = robot('context')('robot')
        with pytest.raises(AttributeError, match="'function' object has no attribute 'handle'") as caught:
            node.create_timer(1.0, print)
        assert facts_of(caught.value)['attribute'] == 'context'


@pytest.mark.parametrize('name', ['subscriptions', 'timers', 'clients', 'services', 'guards', 'waitables'])
def test_what_an_executor_needs(program: Program, name: str) -> None:
    @program
    def body() -> None:
        node = robot(name)('robot')
        with pytest.raises(TypeError, match=METHOD + 'is not iterable') as caught:
            rclpy.spin_once(node, timeout_sec=0)
        assert facts_of(caught.value)['attribute'] == name


def test_a_node_that_is_spun_again_and_again_is_asked_once(program: Program) -> None:
    @program
    def body() -> None:
        asked: list[Node] = []
        node = type('Robot', (Node,), {'guards': property(lambda self: asked.append(self) or [])})('robot')
        for _ in range(3):
            rclpy.spin_once(node, timeout_sec=0)
        assert asked == [node]


def test_names_that_nobody_else_needs_are_free(program: Program) -> None:
    @program
    def body() -> None:
        node = robot('publishers')('robot')
        rclpy.spin_once(node, timeout_sec=0)


def test_a_property_of_the_same_meaning_may_take_the_place_of_one(program: Program) -> None:
    @program
    def body() -> None:
        class Robot(Node):
            @property
            def default_callback_group(self) -> rclpy.callback_groups.CallbackGroup:
                return super().default_callback_group

            @property
            def executor(self) -> rclpy.executors.Executor | None:
                return None

            @executor.setter
            def executor(self, executor: rclpy.executors.Executor | None) -> None:
                self.mine = executor

        Robot('robot').create_timer(1.0, print)


@pytest.mark.parametrize('when', ['before', 'after'])
def test_a_handle_cannot_be_set(program: Program, when: str) -> None:
    @program
    def body() -> None:
        class Robot(Node):
            def __init__(self) -> None:
                if when == 'before':
                    self.handle = []
                super().__init__('robot')
                self.handle = []

        with pytest.raises(AttributeError, match='^handle cannot be modified after node creation$'):
            Robot()


def test_the_error_names_the_class_as_python_does(program: Program) -> None:
    @program
    def body() -> None:
        class Robot(Node):
            pass

        with pytest.raises(AttributeError, match=r"property 'timers' of 'test_\w+\.\S+\.Robot' object has no setter"):
            Robot('robot').timers = []  # type: ignore[misc]


@pytest.mark.parametrize(
    ('name', 'value', 'is_told'),
    [
        ('_clients', {}, True),
        ('_publishers', None, True),
        ('_timers', [], False),
        ('_parameters', [], True),
        ('_parameters', {}, False),
        ('_clock', 3, True),
        ('_logger', 'robot', True),
        ('_mine', {}, False),
    ],
)
def test_private_names_of_the_real_rclpy(program: Program, name: str, value: object, is_told: bool) -> None:
    @program
    def body() -> None:
        class Robot(Node):
            def __init__(self) -> None:
                super().__init__('robot')
                setattr(self, name, value)

        told = [(kind, data['node'], data['attribute'], data['file']) for kind, data in private_names(Robot())]
        assert told == ([('private name', '/robot', name, __file__)] if is_told else [])


def test_a_class_without_a_constructor_is_given_no_line_of_ours(program: Program) -> None:
    @program
    def body() -> None:
        class Robot(Node):
            pass

        node = Robot('robot')
        node._clients = {}  # type: ignore[attr-defined]
        assert list(private_names(node)) == [('private name', {'node': '/robot', 'attribute': '_clients'})]


def test_what_rclpy_itself_gave_may_be_kept_under_its_private_name(program: Program) -> None:
    @program
    def body() -> None:
        node = Node('robot')
        node._logger, node._clock, node._context = node.get_logger(), node.get_clock(), node.context  # type: ignore[attr-defined]
        assert list(private_names(node)) == []
