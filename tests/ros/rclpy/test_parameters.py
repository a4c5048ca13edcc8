"""Parameters of rclpy nodes: declared, read, limited, from outside, and what others hear of them."""

from __future__ import annotations

from typing import Any

import pytest
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.node import Node
from rclpy.parameter import Parameter

from .conftest import Ros, World, raised, results


def test_a_node_begins_with_two_parameters(ros: Ros, world: World) -> None:
    ros(lambda: world.say(list(Node('n').get_parameters_by_prefix(''))))
    assert [what for _, _, what in world.log] == [['use_sim_time', 'start_type_description_service']]


def test_declared_values_are_read_back(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        world.say(node.declare_parameter('p', 1.5).value)
        world.say((node.get_parameter('p').value, node.get_parameter('p').get_parameter_value().double_value))

    assert ros(body) == [1.5, (1.5, 1.5)]


def test_declare_parameters_puts_the_namespace_before_the_names(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameters('ns', [('a', 1), ('b', 'x', ParameterDescriptor())])
        world.say({name: parameter.value for name, parameter in node.get_parameters_by_prefix('ns').items()})

    assert ros(body) == [{'a': 1, 'b': 'x'}]


def test_a_declaration_by_name_only_is_deprecated_and_dynamic(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.warns(UserWarning, match="when declaring parameter named 'p', declaring a parameter only providing its name"):
            node.declare_parameter('p')
        world.say(results(node, 1, 'text'))

    assert ros(body) == [['', '']]


@pytest.mark.parametrize(
    ('arguments', 'outcome'),
    [
        (['-p', 'p:=2.5'], 2.5),
        (
            ['-p', 'p:=5'],
            "InvalidParameterTypeException: Trying to set parameter 'p' to '5' of type 'INTEGER', expecting type 'DOUBLE': p",
        ),
        (
            ['-p', 'p:=50.0'],
            'InvalidParameterValueException: Invalid parameter value (50.0) for parameter. '
            'Reason: Parameter p out of range Min: 0.0, Max: 10.0, value: 50.0: p',
        ),
        (['-p', 'other:p:=3.0'], 1.0),
    ],
)
def test_values_from_outside_take_the_place_of_defaults(ros: Ros, world: World, arguments: list[str], outcome: Any) -> None:
    def body() -> None:
        node = Node('n')
        descriptor = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=10.0)])
        if isinstance(outcome, str):
            world.say(raised(node.declare_parameter, 'p', 1.0, descriptor))
        else:
            world.say(node.declare_parameter('p', 1.0, descriptor).value)

    assert ros(body, '--ros-args', *arguments) == [outcome]


def test_overrides_that_nobody_declares_are_ignored(ros: Ros, world: World) -> None:
    assert ros(lambda: world.say(Node('n').has_parameter('p')), '--ros-args', '-p', 'p:=1') == [False]


def test_overrides_can_be_declared_all_at_once(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', automatically_declare_parameters_from_overrides=True, parameter_overrides=[Parameter('q', value='x')])
        world.say((node.get_parameter('p').value, node.get_parameter('q').value))

    assert ros(body, '--ros-args', '-p', 'p:=1') == [(1, 'x')]


def test_undeclared_parameters_may_be_allowed(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', allow_undeclared_parameters=True)
        world.say((node.get_parameter('p').value, results(node, 1, 'text'), node.get_parameter('p').value))

    assert ros(body) == [(None, ['', ''], 'text')]


@pytest.mark.parametrize(
    ('prefixes', 'depth', 'names'),
    [([], 1, ['use_sim_time', 'start_type_description_service', 'a']), (['x'], 0, ['x.b', 'x.y.c']), (['x'], 1, ['x.b'])],
)
def test_listing_by_prefix_and_depth(ros: Ros, world: World, prefixes: list[str], depth: int, names: list[str]) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameters('', [('a', 1), ('x.b', 1), ('x.y.c', 1)])
        world.say(node.list_parameters(prefixes, depth).names)

    assert ros(body) == [names]
    assert ListParameters.Request.DEPTH_RECURSIVE == 0
    assert GetParameters.Request(names=['a']).names == ['a']


def test_the_alternative_of_get_parameter_or(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        world.say((node.get_parameter_or('p', alternative_value=Parameter('p', value=4)).value, node.get_parameter_or('p').value))

    assert ros(body) == [(4, None)]


def test_a_typed_parameter_without_value_has_no_type_and_gives_the_alternative(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', Parameter.Type.INTEGER)
        world.say((node.get_parameter_type('p'), node.get_parameter_or('p', Parameter('other', value=3)).value))

    assert ros(body) == [(0, 3)]


def test_a_descriptor_is_not_copied(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        descriptor = ParameterDescriptor()
        node.declare_parameter('p', 1, descriptor)
        node.declare_parameter('q', 'text', descriptor)
        world.say((node.describe_parameter('p').name, results(node, 2)))

    assert ros(body) == [('q', ["Wrong parameter type, expected 'Type.STRING' got 'Type.INTEGER'"])]


@pytest.mark.parametrize(
    ('prefixes', 'depth', 'error'),
    [
        ([1], 0, 'TypeError: All prefixes must be instances of type str'),
        ([], 1.0, 'TypeError: The depth must be instance of type int'),
        ([], -1, 'ValueError: The depth must be greater than or equal to zero'),
    ],
)
def test_prefixes_are_texts_and_the_depth_is_an_integer(ros: Ros, world: World, prefixes: Any, depth: Any, error: Any) -> None:
    ros(lambda: world.say(raised(Node('n').list_parameters, prefixes, depth)))
    assert world.log[0][2] == error


def test_an_undeclared_parameter_has_an_empty_descriptor_where_it_is_allowed(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', allow_undeclared_parameters=True)
        node.set_parameters([Parameter('p', value=1)])
        descriptor = node.describe_parameter('p')
        world.say((descriptor.name, descriptor.type, descriptor.dynamic_typing, node.get_parameter_type('q')))

    assert ros(body) == [('', 0, True, Parameter.Type.NOT_SET)]


def test_an_empty_list_from_outside_leaves_a_parameter_without_value(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', cli_args=['--ros-args', '-p', 'p:=[]'])
        world.say(node.declare_parameter('p', [1.0]).value)
        world.say(raised(node.get_parameter, 'p'))

    assert ros(body) == [None, "ParameterUninitializedException: The parameter 'p' is not initialized: p"]


def test_a_new_descriptor_is_checked_against_the_value_and_replaces_the_old_one(ros: Ros, world: World) -> None:
    def ranged(low: float, high: float, **more: Any) -> ParameterDescriptor:
        return ParameterDescriptor(
            type=3, floating_point_range=[FloatingPointRange(from_value=low, to_value=high)], description='speed', **more
        )

    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 1.5)
        world.say(raised(node.set_descriptor, 'q', ParameterDescriptor()))
        world.say(raised(node.set_descriptor, 'p', ranged(5.0, 9.0)))
        world.say((node.describe_parameter('p').description, node.get_parameter('p').value))
        other = Parameter('p', value=6.5).get_parameter_value()
        world.say(node.set_descriptor('p', ranged(5.0, 9.0), other).double_value)
        world.say((node.describe_parameter('p').description, node.describe_parameter('p').name, results(node, 10.0)))
        world.say(raised(node.set_descriptor, 'p', ranged(7.0, 9.0), Parameter('p', value=2.5).get_parameter_value()))
        world.say(node.set_descriptor('p', ranged(6.0, 9.0, read_only=True)).double_value)
        world.say((results(node, 8.0), raised(node.set_descriptor, 'p', ranged(1.0, 9.0))))
        node.declare_parameter('r', 1.5)
        world.say(node.set_descriptor('r', ranged(5.0, 9.0, read_only=True), other).double_value)

    out_of_range = 'Parameter p out of range Min: {}, Max: 9.0, value: {}'
    refused = 'InvalidParameterValueException: Invalid parameter value ({}) for parameter. Reason: {}: p'
    assert ros(body) == [
        'ParameterNotDeclaredException: Invalid access to undeclared parameter(s): q',
        refused.format('1.5', out_of_range.format(5.0, 1.5)),
        ('', 1.5),
        6.5,
        ('speed', 'p', [out_of_range.format(5.0, 10.0)]),
        refused.format('2.5', out_of_range.format(7.0, 2.5)),
        6.5,
        (['Trying to set a read-only parameter: p.'], 'ParameterImmutableException: Attempted to modify read-only parameter: p'),
        6.5,
    ]
