"""Parameters of rclpy nodes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, ParameterEvent, SetParametersResult
from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient

from .conftest import World

Ros = Callable[..., list[Any]]


def raised(call: Callable[..., Any], *arguments: Any, **options: Any) -> tuple[str, str]:
    """The name and the text of the exception that a call ends with."""
    with pytest.raises(Exception) as caught:  # noqa: PT011
        call(*arguments, **options)
    return type(caught.value).__name__, str(caught.value)


def results(node: Node, *values: Any) -> list[str]:
    """Set parameter p to each value; the reasons, '' for success."""
    return [node.set_parameters([Parameter('p', value=value)])[0].reason for value in values]


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
            (node.declare_parameter, '', 1),
        ):
            world.say(raised(call, *arguments))

    assert ros(body) == [
        ('ParameterNotDeclaredException', 'Invalid access to undeclared parameter(s): q'),
        ('ParameterAlreadyDeclaredException', "Parameter(s) already declared: ['p']"),
        ('ParameterUninitializedException', "The parameter 'typed' is not initialized: typed"),
        ('ParameterImmutableException', 'Attempted to modify read-only parameter: fixed'),
        ('ParameterNotDeclaredException', 'Invalid access to undeclared parameter(s): []'),
        ('ValueError', 'Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET'),
        ('InvalidParameterException', 'Invalid parameter name: '),
    ]


def test_a_declaration_by_name_only_is_deprecated_and_dynamic(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.warns(UserWarning, match="when declaring parameter named 'p', declaring a parameter only providing its name"):
            node.declare_parameter('p')
        world.say(results(node, 1, 'text'))

    assert ros(body) == [['', '']]


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


@pytest.mark.parametrize(
    ('arguments', 'outcome'),
    [
        (['-p', 'p:=2.5'], 2.5),
        (
            ['-p', 'p:=5'],
            ('InvalidParameterTypeException', "Trying to set parameter 'p' to '5' of type 'INTEGER', expecting type 'DOUBLE': p"),
        ),
        (
            ['-p', 'p:=50.0'],
            (
                'InvalidParameterValueException',
                'Invalid parameter value (50.0) for parameter. '
                'Reason: Parameter p out of range Min: 0.0, Max: 10.0, value: 50.0: p',
            ),
        ),
        (['-p', 'other:p:=3.0'], 1.0),
    ],
)
def test_values_from_outside_take_the_place_of_defaults(ros: Ros, world: World, arguments: list[str], outcome: Any) -> None:
    def body() -> None:
        node = Node('n')
        descriptor = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=10.0)])
        if isinstance(outcome, tuple):
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


def test_other_programs_read_and_change_parameters(world: World) -> None:
    def owner() -> None:
        rclpy.init()
        node = Node('owner')
        node.declare_parameter('p', 1)
        rclpy.spin(node)

    def program() -> None:
        rclpy.init()
        node = Node('n')
        client = AsyncParameterClient(node, 'owner')
        client.wait_for_services()

        def ask(future: Any) -> Any:
            rclpy.spin_until_future_complete(node, future)
            return future.result()

        world.say([one.reason for one in ask(client.set_parameters([Parameter('p', value=2), Parameter('q', value=1)])).results])
        world.say([parameter_value_to_python(value) for value in ask(client.get_parameters(['p'])).values])
        world.say((ask(client.get_parameters(['p', 'q'])).values, list(ask(client.get_parameter_types(['p'])).types)))
        world.say(ask(client.list_parameters()).result.names)
        world.say(ask(client.describe_parameters(['p'])).descriptors[0].type)

    world.start(owner, name='owner')
    world.start(program)
    assert [what for _, _, what in world.run(1)] == [
        ['', 'Invalid access to undeclared parameter(s): []'],
        [2],
        ([], [2]),
        ['use_sim_time', 'start_type_description_service', 'p'],
        2,
    ]


def test_services_can_be_left_out(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', start_parameter_services=False)
        world.say([name for name, _ in node.get_service_names_and_types()])

    assert ros(body) == [['/n/get_type_description']]


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

    assert ros(body) == [(('ParameterNotDeclaredException', 'Invalid access to undeclared parameter(s): []'), False)]


def test_something_that_is_no_parameter_cannot_be_set(ros: Ros, world: World) -> None:
    ros(lambda: world.say(raised(Node('n').set_parameters, [('p', 1)])))
    assert world.log[0][2] == ('TypeError', "parameter must be instance of type '<class 'rclpy.parameter.Parameter'>'")


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
        ([1], 0, ('TypeError', 'All prefixes must be instances of type str')),
        ([], 1.0, ('TypeError', 'The depth must be instance of type int')),
        ([], -1, ('ValueError', 'The depth must be greater than or equal to zero')),
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
        world.say(raised(node.get_parameter, 'p')[0])

    assert ros(body) == [None, 'ParameterUninitializedException']


@pytest.mark.parametrize(
    ('end', 'error', 'value', 'declared'),
    [
        (
            lambda node: node.destroy_node(),
            ('InvalidHandle', 'cannot use Destroyable because destruction was requested'),
            1,
            False,
        ),
        (lambda _: rclpy.shutdown(), ('RCLError', "Failed to publish: publisher's context is invalid"), 2, True),
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


def test_a_file_is_loaded_whatever_nodes_it_is_for(world: World, tmp_path: Any) -> None:
    from rclpy.parameter_client import AsyncParameterClient

    file = tmp_path / 'p.yaml'
    file.write_text('/one:\n  ros__parameters: {a: 1}\n/two:\n  ros__parameters: {b: 2}\n/**:\n  ros__parameters: {all: 3}\n')

    def program() -> None:
        rclpy.init()
        node = Node('n', allow_undeclared_parameters=True)
        client = AsyncParameterClient(node, 'n')
        for wildcard in (False, True):
            rclpy.spin_until_future_complete(node, client.load_parameter_file(str(file), wildcard))
            world.say([node.has_parameter(name) for name in ('a', 'b', 'all')])

    assert world.run_program(program) == [[True, True, False], [True, True, True]]
