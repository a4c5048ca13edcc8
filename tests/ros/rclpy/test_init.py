"""rclpy: init, shutdown, signals, what belongs to one program."""

from __future__ import annotations

import signal
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
import rclpy
from rclpy._rclpy_pybind11 import RCLError, RCLInvalidROSArgsError, UnknownROSArgsError
from rclpy.context import Context
from rclpy.exceptions import NotInitializedException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.signals import get_current_signal_handlers_options
from rclpy.utilities import remove_ros_args

from .conftest import World


def test_init_twice_is_refused(world: World) -> None:
    def program() -> None:
        rclpy.init()
        with pytest.raises(RuntimeError, match=r'Context.init\(\) must only be called once'):
            rclpy.init()
        world.say('refused')

    assert world.run_program(program) == ['refused']


@pytest.mark.parametrize(
    ('enclave', 'problem', 'index'),
    [
        ('robots', "must be absolute, it must lead with a '/'", 0),
        ('', 'must not be empty', 0),
        ('/a//b', "must not contain repeated '/'", 3),
        ('/5', 'must not have a token that starts with a number', 1),
    ],
)
def test_an_invalid_enclave_is_refused(world: World, enclave: str, problem: str, index: int) -> None:
    def program() -> None:
        rclpy.init(args=['--ros-args', '--enclave', '/robots'])
        rclpy.shutdown()
        with pytest.raises(RCLError) as refused:
            rclpy.init(args=['--ros-args', '-e', enclave])
        world.say((str(refused.value), rclpy.ok()))

    words = f"failed to initialize rcl: Enclave name is not valid: 'context name {problem}'. Invalid index: {index}"
    assert world.run_program(program) == [(words, False)]


def test_init_works_again_after_a_shutdown(world: World) -> None:
    def program() -> None:
        for _ in range(2):
            rclpy.init()
            world.say(rclpy.ok())
            rclpy.shutdown()
        world.say(rclpy.ok())

    assert world.run_program(program) == [True, True, False]


def test_shutdown_without_init_is_refused_and_try_shutdown_is_not(world: World) -> None:
    def program() -> None:
        rclpy.try_shutdown()
        with pytest.raises(RuntimeError, match='Context must be initialized before it can be shutdown'):
            rclpy.shutdown()
        world.say('refused')

    assert world.run_program(program) == ['refused']


def test_a_node_needs_init(world: World) -> None:
    def program() -> None:
        with pytest.raises(NotInitializedException) as caught:
            Node('n')
        world.say(str(caught.value))

    assert world.run_program(program) == ['rclpy.init() has not been called. msg:cannot create node']


@pytest.mark.parametrize(
    ('arguments', 'error', 'text'),
    [
        (['--foo', '-x'], UnknownROSArgsError, "['--foo', '-x']"),
        (['-r', 'x'], RCLError, "failed to initialize rcl: Couldn't parse remap rule: '-r x'. Error: "),
        (['-p', 'x'], RCLError, "failed to initialize rcl: Couldn't parse parameter override rule: '-p x'. Error: "),
        (['-r'], RCLError, "failed to initialize rcl: Couldn't parse trailing -r flag. No remap rule found."),
        (
            ['--params-file', '/no'],
            RCLError,
            "failed to initialize rcl: Couldn't parse params file: '--params-file /no'. Error: ",
        ),
    ],
)
def test_bad_ros_arguments_end_init(world: World, arguments: list[str], error: type[Exception], text: str) -> None:
    def program() -> None:
        with pytest.raises(error) as caught:
            rclpy.init()
        world.say(text in str(caught.value))

    assert world.run_program(program, '--ros-args', *arguments) == [True]


def test_bad_arguments_of_a_node_are_another_error(world: World) -> None:
    def program() -> None:
        rclpy.init()
        with pytest.raises(RCLInvalidROSArgsError, match="Failed to parse ROS arguments: Couldn't parse trailing -r flag"):
            Node('n', cli_args=['--ros-args', '-r'])
        world.say(remove_ros_args(['x', 'a:=b', '--ros-args', '-r', 'c:=d', '--', 'y']))

    assert world.run_program(program) == [['x', 'y']]


def test_a_remap_rule_without_flag_is_used_with_a_warning(world: World) -> None:
    def program() -> None:
        rclpy.init()
        world.say(Node('n').resolve_topic_name('a'))

    assert world.run_program(program, 'a:=b') == ['/b']
    assert (
        30,
        'rcl',
        "Found remap rule 'a:=b'. This syntax is deprecated. Use '--ros-args --remap a:=b' instead.",
    ) in world.tracer.logs


def test_arguments_are_a_list_of_texts(world: World) -> None:
    def program() -> None:
        for arguments in (('--ros-args',), [3]):
            with pytest.raises(TypeError, match='incompatible constructor arguments|bad argument type'):
                rclpy.init(args=arguments)  # type: ignore[arg-type]
        world.say(rclpy.ok())

    assert world.run_program(program) == [False]


def test_a_node_that_outlives_its_context_does_not_keep_its_name(world: World) -> None:
    def program() -> None:
        for _ in range(2):
            rclpy.init()
            world.say(Node('n').get_name())
            rclpy.shutdown()

    assert world.run_program(program) == ['n', 'n']
    assert world.tracer.logs == []


@pytest.mark.parametrize(('text', 'number'), [('', 0), (' 7', 7), ('42nd', 42)])
def test_the_domain_comes_from_the_environment(world: World, text: str, number: int) -> None:
    def program() -> None:
        rclpy.init()
        world.say(rclpy.get_default_context().get_domain_id())

    assert world.run_program(program, env={'ROS_DOMAIN_ID': text}) == [number]


def test_a_domain_that_is_no_number_ends_init(world: World) -> None:
    def program() -> None:
        rclpy.init()

    process = world.start(program, env={'ROS_DOMAIN_ID': 'home'})
    world.run(1)
    assert process.returncode == 1
    assert 'RCLError: failed to initialize rcl: ROS_DOMAIN_ID is not an integral number' in world.output['main']


def test_two_programs_have_contexts_of_their_own(world: World) -> None:
    def first() -> None:
        rclpy.init()
        rclpy.spin(Node('first'))

    def second() -> None:
        world.say(rclpy.ok())

    world.start(first, name='first')
    world.start(second, name='second')
    assert world.run(1) == [(0.0, 'second', False)]


def test_a_spinning_program_ends_by_keyboard_interrupt_on_sigint(world: World) -> None:
    def program() -> None:
        rclpy.init()
        try:
            rclpy.spin(Node('n'))
        except KeyboardInterrupt:
            world.say(('interrupted', rclpy.ok()))

    process = world.start(program)
    world.run(1)
    process.send_signal(signal.SIGINT)
    assert world.run(1) == [(1000.0, 'main', ('interrupted', False))]
    assert process.returncode == 0


def test_shutdown_after_ctrl_c_raises_as_in_ros(world: World) -> None:
    def program() -> None:
        rclpy.init()
        try:
            rclpy.spin(Node('n'))
        except KeyboardInterrupt:
            with pytest.raises(RuntimeError):
                rclpy.get_default_context().shutdown()
            rclpy.try_shutdown()
            rclpy.init()
            rclpy.spin_once(Node('again'), timeout_sec=0.0)
            world.say('still alive')

    process = world.start(program)
    world.run(1)
    process.send_signal(signal.SIGINT)
    assert world.run(1) == [(1000.0, 'main', 'still alive')]
    assert RCLError.__module__ == 'rclpy._rclpy_pybind11'


def test_sigterm_ends_spin_with_external_shutdown(world: World) -> None:
    def program() -> None:
        rclpy.init()
        try:
            rclpy.spin(Node('n'))
        except ExternalShutdownException as error:
            world.say(type(error).__module__)

    process = world.start(program)
    world.run(1)
    process.send_signal(signal.SIGTERM)
    assert world.run(1) == [(1000.0, 'main', 'rclpy.executors')]


def test_a_handler_that_was_there_before_is_called_too(world: World) -> None:
    def program() -> None:
        from edulaunch.engine.processes.current import current_process

        current_process().signals.handlers[signal.SIGINT] = lambda _: world.say('own handler')
        rclpy.init()
        try:
            rclpy.spin(Node('n'))
        except ExternalShutdownException:
            world.say('ended')

    process = world.start(program)
    world.run(1)
    process.send_signal(signal.SIGINT)
    assert [what for _, _, what in world.run(1)] == ['own handler', 'ended']


def test_polling_ok_lets_time_pass(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        start = node.get_clock().now()
        while rclpy.ok() and (node.get_clock().now() - start).nanoseconds < 2 * 10**7:
            pass
        world.say('it is later')

    assert world.run_program(program) == ['it is later']


def test_the_global_executor_ends_with_shutdown(world: World) -> None:
    def program() -> None:
        rclpy.init()
        executor = rclpy.get_global_executor()
        assert isinstance(executor, SingleThreadedExecutor)
        rclpy.shutdown()
        rclpy.init()
        world.say(rclpy.get_global_executor() is executor)

    assert world.run_program(program) == [False]


def test_remove_ros_args_keeps_the_rest() -> None:
    assert not hasattr(rclpy, 'remove_ros_args')
    assert remove_ros_args(['x', '1', '--ros-args', '-r', 'a:=b', '--', '2']) == ['x', '1', '2']


@pytest.mark.processes
def test_importing_rclpy_loads_nothing_heavy() -> None:
    root = Path(__file__).resolve().parents[3]
    code = (
        'import sys, edulaunch; edulaunch.source(); import rclpy, rclpy.node, rclpy.executors; '
        "print(sorted({'numpy', 'asyncio', 'yaml', 'logging', 'typing_extensions'} & set(sys.modules)))"
    )
    done: Any = subprocess.run([sys.executable, '-c', code], cwd=root, capture_output=True, text=True, check=False)
    assert (done.stdout.strip(), done.stderr) == ('[]', '')


@pytest.mark.processes
@pytest.mark.parametrize(
    'name',
    [
        'Future',
        'event_handler.UnsupportedEventTypeError',
        'node.NodeNameNonExistentError',
        'topic_endpoint_info.TypeHash',
        'waitable.Waitable',
        'executors.await_or_execute',
        'time.Time',
    ],
)
def test_import_rclpy_brings_what_it_brings_in_ros2(name: str) -> None:
    root = Path(rclpy.__file__).parents[1]
    program = f'import sys; sys.path[:0] = {[str(root), str(root.parents[2])]}; import rclpy; rclpy.{name}'
    subprocess.run([sys.executable, '-c', program], check=True)


def test_the_options_of_signal_handlers_are_flags() -> None:
    from rclpy.signals import SignalHandlerOptions

    assert [
        option.value
        for option in (
            SignalHandlerOptions.NO,
            SignalHandlerOptions.SIGINT,
            SignalHandlerOptions.SIGTERM,
            SignalHandlerOptions.ALL,
        )
    ] == [0, 1, 2, 3]
    assert list(SignalHandlerOptions.__members__) == ['ALL', 'NO', 'SIGINT', 'SIGTERM']
    assert int(SignalHandlerOptions.ALL) == 3
    with pytest.raises(TypeError, match="^'pybind11_type' object is not iterable$"):
        list(SignalHandlerOptions)
    with pytest.raises(TypeError, match="^object of type 'pybind11_type' has no len"):
        len(SignalHandlerOptions)
    assert SignalHandlerOptions


def test_a_module_that_jazzy_does_not_have_is_not_here() -> None:
    with pytest.raises(ModuleNotFoundError, match="No module named 'rclpy.handle'"):
        import_module('rclpy.handle')


def test_a_star_import_of_lifecycle_leaves_the_short_names_alone() -> None:
    import rclpy.lifecycle

    assert sorted(rclpy.lifecycle.__all__) == [
        'LifecycleNode',
        'LifecycleNodeMixin',
        'LifecyclePublisher',
        'LifecycleState',
        'ManagedEntity',
        'SimpleManagedEntity',
    ]
    assert rclpy.lifecycle.Node is rclpy.lifecycle.LifecycleNode


def test_on_shutdown_of_a_context_that_has_ended_calls_at_once(world: World) -> None:
    def program() -> None:
        context = Context()
        context.init()
        context.shutdown()
        context.on_shutdown(lambda: world.say('called'))
        with pytest.raises(TypeError) as caught:
            context.on_shutdown(5)  # type: ignore[arg-type]
        world.say(str(caught.value))

    assert world.run_program(program) == ['called', "('callback should be a callable, got {}', <class 'int'>)"]


def test_the_options_of_signal_handlers_print_with_their_class() -> None:
    assert str(rclpy.signals.SignalHandlerOptions.SIGINT) == 'SignalHandlerOptions.SIGINT'


def test_after_try_shutdown_signals_stay_handled(world: World) -> None:
    def body() -> None:
        for end in (rclpy.try_shutdown, rclpy.shutdown):
            rclpy.init()
            end()
            world.say(str(get_current_signal_handlers_options()))
        with pytest.raises(TypeError):
            rclpy.try_shutdown(uninstall_handlers=True)  # type: ignore[call-arg]

    assert world.run_program(body) == ['SignalHandlerOptions.ALL', 'SignalHandlerOptions.NO']


def test_half_a_character_is_no_argument(world: World) -> None:
    def program() -> None:
        with pytest.raises(UnicodeEncodeError):
            rclpy.Context().init(args=['\udcbf'])

    world.run_program(program)
