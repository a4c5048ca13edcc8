"""rclpy.logging: lines, levels, filters, /rosout."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import rclpy
from rcl_interfaces.msg import Log
from rclpy.logging import (
    LoggingSeverity,
    clear_config,
    get_logger,
    get_logger_effective_level,
    get_logger_level,
    get_logging_directory,
    set_logger_level,
)
from rclpy.node import Node

from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def output(world: World, body: Callable[[], Any], *arguments: str, env: dict[str, str] | None = None) -> list[str]:
    def program() -> None:
        rclpy.init()
        body()

    world.run_program(program, *arguments, env=env)
    return world.output['main'].splitlines()


def every_severity(node: Node) -> None:
    logger = node.get_logger()
    logger.debug('text')
    logger.info('text')
    logger.warning('text')
    logger.error('text')
    logger.fatal('text')


def test_console_lines_carry_simulated_time(world: World) -> None:
    def body() -> None:
        node = Node('n', namespace='/a/b')
        sleep(1.5)
        every_severity(node)

    assert output(world, body) == [
        f'[{severity}] [1700000001.500000000] [a.b.n]: text' for severity in ('INFO', 'WARN', 'ERROR', 'FATAL')
    ]
    assert [level for level, _, _ in world.tracer.logs] == [20, 30, 40, 50]


@pytest.mark.parametrize(('level', 'count'), [('debug', 5), ('WARN', 3), ('n:=error', 2), ('other:=fatal', 4)])
def test_levels_come_from_the_command_line(world: World, level: str, count: int) -> None:
    assert len(output(world, lambda: every_severity(Node('n')), '--ros-args', '--log-level', level)) == count


@pytest.mark.parametrize(
    ('env', 'line'),
    [
        ({'RCUTILS_CONSOLE_OUTPUT_FORMAT': '{severity} {name}: {message} {nonsense} {'}, 'INFO n: text {nonsense} {'),
        (
            {'RCUTILS_CONSOLE_OUTPUT_FORMAT': '{time_as_nanoseconds} {date_time_with_ms}'},
            '1700000000000000000 2023-11-14 22:13:20.000',
        ),
        ({'RCUTILS_CONSOLE_OUTPUT_FORMAT': '{function_name}', 'RCUTILS_COLORIZED_OUTPUT': '1'}, '\033[0m<lambda>\033[0m'),
    ],
)
def test_the_format_comes_from_the_environment(world: World, env: dict[str, str], line: str) -> None:
    assert output(world, lambda: Node('n').get_logger().info('text'), env=env) == [line]


def test_colours_are_for_the_whole_line(world: World) -> None:
    lines = output(world, lambda: every_severity(Node('n')), env={'RCUTILS_COLORIZED_OUTPUT': '1'})
    assert [line[: line.index('m') + 1] for line in lines] == ['\033[0m', '\033[33m', '\033[31m', '\033[31m']
    assert all(line.endswith('\033[0m') for line in lines)


def test_children_inherit_levels_and_may_have_their_own(ros: Ros, world: World) -> None:
    def body() -> None:
        logger = Node('n').get_logger()
        child = logger.get_child('part')
        logger.set_level(LoggingSeverity.ERROR)
        world.say((child.name, child.get_effective_level().name, child.is_enabled_for(LoggingSeverity.WARN)))
        set_logger_level('n.part', LoggingSeverity.DEBUG)
        world.say((get_logger_effective_level('n.part').name, get_logger_effective_level('n').name, child.debug('text')))

    assert ros(body) == [('n.part', 'ERROR', False), ('DEBUG', 'ERROR', True)]


@pytest.mark.parametrize(
    ('options', 'written'),
    [
        ({}, [0, 1, 2, 3, 4]),
        ({'once': True}, [0]),
        ({'skip_first': True}, [1, 2, 3, 4]),
        ({'throttle_duration_sec': 1.0}, [0, 2, 4]),
        ({'throttle_duration_sec': 1.0, 'skip_first': True}, [2, 4]),
    ],
)
def test_filters_belong_to_the_place_of_the_call(ros: Ros, world: World, options: dict[str, Any], written: list[int]) -> None:
    def body() -> None:
        logger = Node('n').get_logger()
        for number in range(5):
            if logger.info(str(number), **options):
                world.say(number)
            sleep(0.5)

    assert ros(body) == written


def test_a_throttle_may_follow_another_clock(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        world.say(
            [node.get_logger().info('x', throttle_duration_sec=1.0, throttle_time_source_type=node.get_clock()) for _ in range(2)]
        )

    assert ros(body) == [[True, False]]


def test_misuse_is_refused(ros: Ros, world: World) -> None:
    def body() -> None:
        logger = Node('n').get_logger()
        for call in (
            lambda: [logger.log('x', severity) for severity in (20, 30)],
            lambda: [logger.info('x', once=once) for once in (True, False)],
            lambda: [logger.info('x', throttle_duration_sec=seconds) for seconds in (1.0, 1.0, 2.0)],
            lambda: logger.info('x', onse=True),
            lambda: logger.info(5),
            lambda: get_logger(''),
            lambda: logger.info('x', throttle_time_source_type=1),
        ):
            with pytest.raises((TypeError, ValueError)) as caught:
                call()
            world.say(f'{caught.type.__name__}: {caught.value}'[:60])

    assert ros(body) == [
        'ValueError: Logger severity cannot be changed between calls.',
        'ValueError: Requested logging filters cannot be changed betw',
        'ValueError: Logging filter parameters cannot be changed betw',
        'TypeError: parameter "onse" is not one of the recognized log',
        'TypeError: rclpy_logging_rcutils_log(): incompatible functio',
        'ValueError: Logger name must not be empty.',
        'TypeError: required parameter "throttle_duration_sec" not sp',
    ]


def test_messages_are_published_on_rosout(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_subscription(Log, '/rosout', lambda log: world.say((log.level, log.name, log.msg, log.function)), 10)
        node.get_logger().get_child('part').warning('heard')
        node.get_logger().debug('below the level')
        rclpy.spin_once(node)

    assert ros(body) == [(30, 'n.part', 'heard', 'body')]


def test_a_second_node_of_a_name_is_warned_of(world: World) -> None:
    lines = output(world, lambda: [Node('n'), Node('n')])
    assert len(lines) == 1
    assert "[rcl.logging_rosout]: Publisher already registered for node name: 'n'. If this is due to multiple nodes" in lines[0]


def test_outputs_can_be_switched_off(world: World) -> None:
    assert output(world, lambda: every_severity(Node('n')), '--ros-args', '--disable-stdout-logs') == []


def test_programs_have_levels_of_their_own(world: World) -> None:
    def quiet() -> None:
        rclpy.init()
        Node('quiet').get_logger().set_level(LoggingSeverity.FATAL)
        sleep(1)

    world.start(quiet, name='quiet')
    assert len(output(world, lambda: Node('quiet').get_logger().info('x'))) == 1


@pytest.mark.parametrize(('message', 'text'), [(None, '(null)'), (b'bytes', 'bytes')])
def test_none_and_bytes_are_messages_too(world: World, message: Any, text: str) -> None:
    assert output(world, lambda: Node('n').get_logger().info(message))[0].endswith(f' [n]: {text}')


def test_a_throttle_goes_by_a_clock_only(world: World) -> None:
    def program() -> None:
        rclpy.init()
        log = Node('n').get_logger()
        with pytest.raises(ValueError, match='Received throttle_time_source_type of "STEADY_TIME" is not a clock instance'):
            log.info('x', throttle_duration_sec=1.0, throttle_time_source_type='STEADY_TIME')
        with pytest.raises(TypeError, match="'throttle_duration_sec', 'throttle_time_source_type', 'skip_first', 'once'"):
            log.info('x', foo=1)
        world.say('refused')

    assert world.run_program(program) == ['refused']


def test_the_directory_of_log_files_is_a_path(world: World) -> None:
    assert world.run_program(lambda: world.say(rclpy.logging.get_logging_directory()), env={'ROS_LOG_DIR': '/x'}) == [Path('/x')]


def test_a_message_may_name_another_logger_by_keyword_only(ros: Ros, world: World) -> None:
    def body() -> None:
        logger = Node('n').get_logger()
        world.say((logger.info('a', name='x'), logger.log('b', 20, name='y'), logger.log('c', 20, name=None)))
        for wrong in (lambda: logger.log('d', 20, 'x'), lambda: logger.info('e', name=5)):
            with pytest.raises(TypeError):
                wrong()

    assert ros(body) == [(True, True, True)]
    assert [(name, text) for _, name, text in world.tracer.logs] == [('x', 'a'), ('y', 'b'), ('', 'c')]


def test_the_logger_service_refuses_a_level_that_there_is_not(ros: Ros, world: World) -> None:
    from rcl_interfaces.msg import LoggerLevel
    from rcl_interfaces.srv import SetLoggerLevels

    def body() -> None:
        node = Node('n', enable_logger_service=True)
        client = node.create_client(SetLoggerLevels, 'n/set_logger_levels')
        future = client.call_async(
            SetLoggerLevels.Request(levels=[LoggerLevel(name='n', level=7), LoggerLevel(name='n', level=30)])
        )
        rclpy.spin_until_future_complete(node, future)
        world.say([(result.successful, result.reason) for result in future.result().results])

    assert ros(body) == [[(False, 'Failed reason: Invalid logger level.'), (True, '')]]


def test_once_counts_what_skip_first_lets_through(ros: Ros, world: World) -> None:
    def body() -> None:
        logger = get_logger('n')
        world.say([logger.info('x', once=True, skip_first=True) for _ in range(4)])

    assert ros(body) == [[False, True, False, False]]


def test_the_root_logger_sets_the_default_level(ros: Ros, world: World) -> None:
    def body() -> None:
        from rclpy import logging

        logging._root_logger.set_level(logging.LoggingSeverity.DEBUG)
        world.say((logging._root_logger.name, logging._root_logger.get_child('a').name, get_logger('n').debug('x')))

    assert ros(body) == [('', 'a', True)]


@pytest.mark.parametrize(
    ('env', 'folder'),
    [
        ({'HOME': '/home/anna'}, '/home/anna/.ros/log'),
        ({'HOME': '/home/anna', 'ROS_HOME': '/data'}, '/data/log'),
        ({'HOME': '/home/anna', 'ROS_HOME': '/data', 'ROS_LOG_DIR': '/logs'}, '/logs'),
    ],
)
def test_the_folder_of_log_files_comes_from_the_environment(world: World, env: dict[str, str], folder: str) -> None:
    found: list[str] = []
    output(world, lambda: found.append(str(get_logging_directory())), env=env)
    assert found == [folder]


def test_clearing_the_configuration_forgets_the_level_of_each_logger(world: World) -> None:
    found: list[str] = []

    def body() -> None:
        set_logger_level('arm', LoggingSeverity.ERROR)
        set_logger_level('', LoggingSeverity.DEBUG)
        clear_config()
        found.extend((get_logger_level('arm').name, get_logger_level('').name))

    output(world, body)
    assert found == ['UNSET', 'INFO']
