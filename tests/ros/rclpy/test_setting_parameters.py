"""Setting parameters of rclpy nodes: limits, callbacks, all or nothing, and who hears of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import rclpy
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    ParameterValue,
    SetParametersResult,
)
from rclpy.node import Node
from rclpy.parameter import Parameter

from .conftest import Ros, World, raised, results


def test_misuse_has_the_texts_of_rclpy(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1)
        node.declare_parameter('typed', Parameter.Type.STRING)
        node.declare_parameter('fixed', 1, ParameterDescriptor(read_only=True))
        for call, *arguments in (
            (node.get_parameter, 'q'),
            (node.declare_parameter, 'p', 2),
            (node.get_parameter, 'typed'),
            (node.undeclare_parameter, 'fixed'),
            (node.set_parameters, [Parameter('q', value=1)]),
            (node.declare_parameter, 'n', None, ParameterDescriptor()),
            (node.declare_parameter, 'v', ParameterValue()),
            (node.declare_parameter, '', 1),
        ):
            world.say(raised(call, *arguments))

    assert ros(body) == [
        'ParameterNotDeclaredException: Invalid access to undeclared parameter(s): q',
        "ParameterAlreadyDeclaredException: Parameter(s) already declared: ['p']",
        "ParameterUninitializedException: The parameter 'typed' is not initialized: typed",
        'ParameterImmutableException: Attempted to modify read-only parameter: fixed',
        'ParameterNotDeclaredException: Invalid access to undeclared parameter(s): []',
        'ValueError: Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET',
        'ValueError: Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET',
        'InvalidParameterException: Invalid parameter name: ',
    ]


def test_types_are_static(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1.0)
        world.say(results(node, 5, None, 5.0))

    assert ros(body) == [
        ["Wrong parameter type, expected 'Type.DOUBLE' got 'Type.INTEGER'", 'Static parameter cannot be undeclared', '']
    ]


@pytest.mark.parametrize(
    ('descriptor', 'first', 'values', 'reasons'),
    [
        (ParameterDescriptor(read_only=True), 1, [2], ['Trying to set a read-only parameter: p.']),
        (
            ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=3)]),
            0,
            [3, 10, 11, 4],
            [
                '',
                '',
                'Parameter p out of range. Min: 0, Max: 10, value: 11',
                'The parameter value for p is not a valid step. Min: 0, max: 10, value: 4, step: 3',
            ],
        ),
        (
            ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)]),
            0.0,
            [0.5, 2.0],
            ['', 'Parameter p out of range Min: 0.0, Max: 1.0, value: 2.0'],
        ),
    ],
)
def test_descriptors_limit_values(ros: Ros, world: World, descriptor: Any, first: Any, values: Any, reasons: Any) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', first, descriptor)
        world.say(results(node, *values))

    assert ros(body) == [reasons]


def test_the_newest_set_callback_is_asked_first_and_the_first_refusal_counts(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1)
        for name, accepts in (('older', True), ('newer', False)):

            def callback(parameters: Any, name: str = name, accepts: bool = accepts) -> Any:
                world.say((name, parameters[0].value))
                return SetParametersResult(successful=accepts, reason='no')

            node.add_on_set_parameters_callback(callback)
        world.say(results(node, 2))
        node.remove_on_set_parameters_callback(callback)
        world.say(results(node, 3))

    assert ros(body) == [('newer', 2), ['no'], ('older', 3), ['']]


def test_a_callback_has_to_be_callable(ros: Ros) -> None:
    def body() -> None:
        node = Node('n')
        for add in (node.add_on_set_parameters_callback, node.add_post_set_parameters_callback):
            with pytest.raises(TypeError) as caught:
                add(3)  # type: ignore[arg-type]
            assert caught.value.args == ('Callback must be callable, got {}', int)

    ros(body)


def test_pre_and_post_callbacks(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1)
        node.add_pre_set_parameters_callback(lambda parameters: [Parameter('p', value=one.value * 2) for one in parameters])
        node.add_post_set_parameters_callback(lambda parameters: world.say(parameters[0].value))
        results(node, 4)
        node.add_pre_set_parameters_callback(lambda parameters: [])
        node.remove_pre_set_parameters_callback(node._rclpy.parameters.pre_callbacks[1])
        world.say(results(node, 5))

    assert ros(body) == [
        8,
        [
            'parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying the '
            'original parameters list.'
        ],
    ]


def test_setting_atomically_is_all_or_nothing(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameters('', [('a', 1), ('b', 1)])
        world.say(node.set_parameters_atomically([Parameter('a', value=2), Parameter('b', value='x')]).successful)
        world.say(node.get_parameter('a').value)

    assert ros(body) == [False, 1]


def test_changes_are_published_and_recorded(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', namespace='ns')
        node.create_subscription(
            ParameterEvent,
            '/parameter_events',
            lambda event: world.say(
                (
                    event.node,
                    [one.name for one in event.new_parameters],
                    [one.value.integer_value for one in event.changed_parameters],
                )
            ),
            10,
        )
        node.declare_parameter('p', 1)
        results(node, 7)
        for _ in range(2):
            rclpy.spin_once(node)

    assert ros(body) == [('/ns/n', ['p'], []), ('/ns/n', [], [7])]
    assert world.tracer.parameters[-2:] == [('/ns/n', 'p', 1, 'default'), ('/ns/n', 'p', 7, 'set_parameters')]


def test_the_record_knows_where_values_came_from(world: World, tmp_path: Path) -> None:
    file = tmp_path / 'params.yaml'
    file.write_text('/n:\n  ros__parameters:\n    a: 1\n')

    def program() -> None:
        rclpy.init()
        Node('n').declare_parameters('', [('a', 0), ('b', 0), ('c', 0)])

    world.run_program(
        program, '--ros-args', '--params-file', str(file), '-p', 'b:=2', '-p', 'c:=3', parameter_origins={'c': 'launch argument'}
    )
    assert world.tracer.parameters[-3:] == [
        ('/n', 'a', 1, 'params.yaml line 3'),
        ('/n', 'b', 2, 'command line'),
        ('/n', 'c', 3, 'launch argument'),
    ]


@pytest.mark.parametrize('answer', [None, True, 'yes'])
def test_a_callback_that_forgets_its_result_refuses_the_change(ros: Ros, world: World, answer: Any) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1)
        node.add_on_set_parameters_callback(lambda parameters: answer)
        with pytest.warns(UserWarning, match='Callback returned an invalid type, it should return SetParameterResult'):
            world.say((results(node, 2), node.get_parameter('p').value))

    assert ros(body) == [(['Callback returned an invalid type'], 1)]


def test_a_pre_callback_cannot_bring_in_an_undeclared_parameter(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1)
        node.add_pre_set_parameters_callback(lambda parameters: [Parameter('q', value=1)])
        world.say((raised(results, node, 2), node.has_parameter('q')))

    assert ros(body) == [('ParameterNotDeclaredException: Invalid access to undeclared parameter(s): []', False)]


def test_something_that_is_no_parameter_cannot_be_set(ros: Ros, world: World) -> None:
    ros(lambda: world.say(raised(Node('n').set_parameters, [('p', 1)])))
    assert world.log[0][2] == "TypeError: parameter must be instance of type '<class 'rclpy.parameter.Parameter'>'"


@pytest.mark.parametrize(
    ('end', 'error', 'value', 'declared'),
    [
        (lambda node: node.destroy_node(), 'InvalidHandle: cannot use Destroyable because destruction was requested', 1, False),
        (lambda _: rclpy.shutdown(), "RCLError: Failed to publish: publisher's context is invalid", 2, True),
    ],
)
def test_after_the_end_parameters_cannot_be_declared_or_set(
    ros: Ros, world: World, end: Any, error: Any, value: int, declared: bool
) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1)
        node.add_post_set_parameters_callback(world.say)
        end(node)
        world.say(raised(node.set_parameters, [Parameter('p', value=2)]))
        world.say(raised(node.declare_parameter, 'q', 1))
        world.say((node.get_parameter('p').value, node.has_parameter('q')))

    assert ros(body) == [error, error, (value, declared)]
