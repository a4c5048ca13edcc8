"""Where launch writes its logs, and how lines of them look."""

from __future__ import annotations

import logging
import os
from pathlib import Path
from typing import Any

import pytest
from launch.logging._state import (
    LaunchLogger,
    LoggingState,
    _free_number,
    _get_logging_directory,
    _make_unique_log_dir,
    _renew_latest_log_dir,
)


@pytest.fixture
def env(fresh_simulation: Any) -> Any:
    return fresh_simulation.env


@pytest.mark.parametrize(
    ('given', 'folder'),
    [
        ({'ROS_LOG_DIR': '/a', 'ROS_HOME': '/b'}, '/a'),
        ({'ROS_HOME': '/b'}, '/b/log'),
        ({'ROS_LOG_DIR': ''}, '~/.ros/log'),
        ({'ROS_LOG_DIR': '~/x'}, '~/x'),
    ],
)
def test_variables_choose_the_folder(env: Any, given: dict[str, str], folder: str) -> None:
    env.update(given)
    assert _get_logging_directory() == os.path.expanduser(folder)


@pytest.mark.parametrize('count', [1, 2, 3, 4, 5, 8, 9])
def test_a_folder_that_is_taken_gets_the_next_number(tmp_path: Path, count: int) -> None:
    first = str(tmp_path / 'log')
    for number in range(1, count):
        os.mkdir(first if number == 1 else f'{first}-{number}')
    assert _free_number(first) == count


def test_a_log_folder_has_date_host_and_process(tmp_path: Path, fresh_simulation: Any) -> None:
    first, second = (_make_unique_log_dir(base_path=str(tmp_path / 'a' / 'b')) for _ in range(2))
    assert second == f'{first}-2'
    assert os.path.isdir(second)
    name = os.path.basename(first)
    assert name.startswith('2023-11-14-22-13-20-000000-')
    assert name.endswith(f'-{fresh_simulation.pid}')


def test_the_latest_folder_has_a_link(tmp_path: Path) -> None:
    for name in ('a', 'b'):
        assert _renew_latest_log_dir(log_dir=str(tmp_path / name)) is True
        assert os.readlink(tmp_path / 'latest') == name
    os.unlink(tmp_path / 'latest')
    (tmp_path / 'latest').write_text('mine')
    assert _renew_latest_log_dir(log_dir=str(tmp_path / 'c')) is False
    assert (tmp_path / 'latest').read_text() == 'mine'


def record(text: str = 'hello') -> logging.LogRecord:
    made = logging.LogRecord('node', logging.WARNING, '/a.py', 3, text, (), None)
    made.created = 12.5
    return made


@pytest.mark.parametrize(
    ('text', 'style', 'line'),
    [
        ('default', None, '[WARNING] [node]: hello'),
        ('default_with_timestamp', None, '12.5000000 [WARNING] [node]: hello'),
        ('{msg}!', None, 'hello!'),
        ('%(msg)s?', '%', 'hello?'),
    ],
)
def test_the_screens_format(env: Any, text: str, style: str | None, line: str) -> None:
    config = LoggingState().config
    handler = config.get_screen_handler()
    assert handler.format(record()) == '[WARNING] [node]: hello'
    config.set_screen_format(text, screen_style=style)
    assert handler.format(record()) == line
    config.set_screen_format(None)
    assert handler.format(record()) == line
    assert config.get_screen_handler() is handler


@pytest.mark.parametrize('kind', ['screen', 'log'])
def test_an_alias_has_its_own_style(env: Any, kind: str) -> None:
    config = LoggingState().config
    with pytest.raises(ValueError, match=f'custom format style for the "default" {kind} format'):
        getattr(config, f'set_{kind}_format')('default', **{f'{kind}_style': '%'})


def test_a_variable_overrides_the_format(env: Any) -> None:
    env['OVERRIDE_LAUNCH_SCREEN_FORMAT'] = r'{msg}\t{name}'
    config = LoggingState().config
    config.set_screen_format('default', screen_style='%')
    assert config.get_screen_handler().format(record()) == 'hello\tnode'


def test_files_are_written_only_if_a_folder_is_given(tmp_path: Path, env: Any) -> None:
    config = LoggingState().config
    nothing = config.get_log_file_handler('x.log')
    assert (type(nothing).__name__, config.get_log_file_handler('x.log') is nothing, config.file_handlers) == (
        'NullHandler',
        True,
        {},
    )
    config.dry = True
    env['ROS_LOG_DIR'] = str(tmp_path)
    assert config.get_log_file_handler('x.log') is nothing
    config.dry = False
    handler = config.get_log_file_handler()
    assert config.get_log_file_handler('launch.log') is handler
    handler.emit(record())
    handler.flush()
    path = config.get_log_file_path()
    assert (os.path.dirname(path), os.path.basename(path)) == (config.log_dir, 'launch.log')
    assert Path(path).read_text() == '12.5000000 [WARNING] [node]: hello\n'
    assert os.path.realpath(tmp_path / 'latest') == os.path.realpath(config.log_dir)
    config.set_log_format('{msg}')
    assert handler.format(record()) == 'hello'
    with pytest.warns(UserWarning, match='already configured to output to log files') as warned:
        config.log_dir = str(tmp_path / 'other')
    assert warned[0].filename == __file__
    assert os.path.dirname(config.log_dir) == str(tmp_path / 'other')
    handler.close()


@pytest.mark.parametrize('variable', ['ROS_LOG_DIR', 'ROS_HOME'])
def test_a_factory_makes_the_files_handler(tmp_path: Path, env: Any, variable: str) -> None:
    env[variable] = str(tmp_path)
    config = LoggingState().config
    asked: list[str] = []
    config.log_handler_factory = lambda path: asked.append(path) or logging.NullHandler()
    config.get_log_file_handler('a.log')
    assert asked == [config.get_log_file_path('a.log')]


def test_loggers_are_known_by_their_names() -> None:
    state = LoggingState()
    assert (state.get_logger(), state.get_logger(''), state.root.level) == (state.root, state.root, logging.INFO)
    plain, dotted = state.get_logger('a'), state.get_logger('a.b')
    assert (state.get_logger('a'), state.get_logger('a.b')) == (plain, dotted)
    assert (plain.parent, dotted.parent, plain.propagate, type(dotted)) == (state.root, plain, False, LaunchLogger)
    state.config.level = logging.ERROR
    assert (state.config.level, plain.isEnabledFor(logging.WARNING), plain.isEnabledFor(logging.ERROR)) == (40, False, True)
    state.reset()
    assert state.get_logger('a') is not plain


def test_a_record_has_simulated_time_and_no_place() -> None:
    state = LoggingState()
    records: list[logging.LogRecord] = []
    handler = logging.NullHandler()
    handler.handle = records.append  # type: ignore[assignment,method-assign]
    for name in ('talker', 'talker-stdout'):
        logger = state.get_logger(name)
        logger.addHandler(handler)
        logger.info('hello')
    assert [(one.created, one.msecs, one.lineno, one.pathname, one.funcName) for one in records] == [
        (1_700_000_000.0, 0, 0, '(unknown file)', '(unknown function)')
    ] * 2
