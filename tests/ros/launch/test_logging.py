"""Loggers of one process: formats, places, levels."""

from __future__ import annotations

import logging
import os
from pathlib import Path
from typing import Any

import launch.logging
import pytest
from launch.logging import get_logger, get_output_loggers, launch_config, log_launch_config, reset


def test_the_default_format_on_the_screen(capsys: Any) -> None:
    get_logger('some.name').warning('text')
    assert capsys.readouterr().out == '[WARNING] [some.name]: text\n'


def test_lines_have_simulated_time(capsys: Any) -> None:
    launch_config.set_screen_format('default_with_timestamp')
    get_logger('n').info('text')
    assert capsys.readouterr().out == '1700000000.0000000 [INFO] [n]: text\n'


def test_the_environment_can_change_the_format(capsys: Any, fresh_simulation: Any) -> None:
    fresh_simulation.env['OVERRIDE_LAUNCH_SCREEN_FORMAT'] = '{name}>\\t{msg}'
    reset()
    get_logger('n').info('text')
    assert capsys.readouterr().out == 'n>\ttext\n'


def test_a_style_cannot_be_given_for_the_default_format() -> None:
    with pytest.raises(ValueError, match='Cannot set a custom format style for the "default" screen format.'):
        launch_config.set_screen_format('default', screen_style='%')


def test_an_own_format_may_have_any_style(capsys: Any) -> None:
    launch_config.set_screen_format('%(levelname)s %(message)s', screen_style='%')
    get_logger('n').info('text')
    assert capsys.readouterr().out == 'INFO text\n'


def test_levels_are_inherited_from_the_root(capsys: Any) -> None:
    get_logger('n').debug('hidden')
    launch_config.level = 10
    get_logger('n').debug('shown')
    assert capsys.readouterr().out == '[DEBUG] [n]: shown\n'


def test_without_a_wish_no_file_is_written(tmp_path: Path, monkeypatch: Any, capsys: Any) -> None:
    monkeypatch.setenv('HOME', str(tmp_path))
    get_logger('n').info('text')
    log_launch_config()
    assert list(tmp_path.iterdir()) == []
    assert 'All log files' not in capsys.readouterr().out


def test_with_ros_log_dir_files_are_written(tmp_path: Path, capsys: Any, fresh_simulation: Any) -> None:
    fresh_simulation.env['ROS_LOG_DIR'] = str(tmp_path)
    logger = get_logger('n')
    log_launch_config(logger=logger)
    for handler in logger.handlers:
        handler.close()
    assert Path(launch_config.log_dir).parent == tmp_path
    assert (tmp_path / 'latest' / 'launch.log').read_text() == (
        f'1700000000.0000000 [INFO] [n]: All log files can be found below {launch_config.log_dir}\n'
        '1700000000.0000000 [INFO] [n]: Default logging verbosity is set to INFO\n'
    )


def test_the_folder_is_below_ros_home_or_home(fresh_simulation: Any) -> None:
    fresh_simulation.env['ROS_HOME'] = '/ros/home'
    assert launch.logging._get_logging_directory() == '/ros/home/log'
    fresh_simulation.env.pop('ROS_HOME')
    assert launch.logging._get_logging_directory() == str(Path.home() / '.ros' / 'log')


def test_two_launches_at_one_time_have_two_folders(tmp_path: Path) -> None:
    first, second = (launch.logging._make_unique_log_dir(base_path=str(tmp_path)) for _ in range(2))
    assert second == first + '-2'


def test_the_thousandth_launch_at_one_time_asks_the_disk_a_few_times_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = launch.logging._make_unique_log_dir(base_path=str(tmp_path))
    for number in range(2, 1000):
        os.mkdir(f'{first}-{number}')
    asked: list[str] = []
    exists = os.path.exists
    monkeypatch.setattr(os.path, 'exists', lambda path: asked.append(path) or exists(path))
    assert launch.logging._make_unique_log_dir(base_path=str(tmp_path)) == f'{first}-1000'
    assert len(asked) < 30


def test_latest_is_not_made_over_a_real_folder(tmp_path: Path) -> None:
    (tmp_path / 'latest').mkdir()
    assert not launch.logging._renew_latest_log_dir(log_dir=str(tmp_path / 'x'))


@pytest.mark.parametrize(
    ('output', 'counts'),
    [
        ('screen', (1, 1)),
        ('log', (1, 2)),
        ('both', (2, 2)),
        ('own_log', (2, 2)),
        ('full', (4, 4)),
        ({'stdout': {'screen', 'log'}}, (2, 0)),
        ({'both': ['own_log']}, (1, 1)),
    ],
)
def test_output_loggers_have_a_handler_for_each_place(output: Any, counts: tuple[int, int]) -> None:
    assert tuple(len(logger.handlers) for logger in get_output_loggers('p', output)) == counts


@pytest.mark.parametrize(
    ('output', 'message'),
    [
        ('x', 'x is not a valid standard output config i.e. "screen", "log" or "both"'),
        ({'x': 'log'}, 'x is not a valid output source i.e. "stdout", "stderr" or "both"'),
        ({'both': 'x'}, 'x is not a valid output destination i.e. "screen", "log" or "own_log"'),
    ],
)
def test_wrong_outputs(output: Any, message: str) -> None:
    with pytest.raises(ValueError) as error:
        get_output_loggers('p', output)
    assert str(error.value) == message


def test_a_factory_makes_the_handlers_of_files(tmp_path: Path) -> None:
    made: list[str] = []

    def factory(path: str) -> Any:
        made.append(path)
        return launch.logging.handlers.NullHandler()

    launch_config.log_dir = str(tmp_path)
    launch_config.log_handler_factory = factory
    get_logger('n')
    assert made == [launch_config.get_log_file_path()]


def test_reset_forgets_everything() -> None:
    before = get_logger('n')
    launch_config.level = 10
    reset()
    assert get_logger('n') is not before
    assert launch_config.level == 20


def test_other_handlers_can_have_a_format_for_one_logger(capsys: Any) -> None:
    handler = launch.logging.handlers.MemoryHandler(10)
    assert hasattr(handler, 'setFormatterFor')
    handler.close()
    with pytest.raises(AttributeError):
        _ = launch.logging.handlers.NoSuchHandler


def test_messages_of_launch_are_recorded_and_output_of_programs_is_not(fresh_simulation: Any, capsys: Any) -> None:
    recorded: list[Any] = []
    fresh_simulation.log = lambda *entry: recorded.append(entry)
    get_logger('n').error('text')
    get_output_loggers('p', 'screen')[0].info('line')
    assert recorded == [(40, 'n', 'text')]


def test_base_handler_has_formats_by_logger_too() -> None:
    handler = launch.logging.handlers.Handler()
    logger = launch.logging.get_logger('special')
    handler.setFormatterFor(logger, logging.Formatter('<%(message)s>'))
    assert handler.format(logger.makeRecord('special', logging.INFO, 'f', 1, 'x', (), None)) == '<x>'


def test_the_configuration_goes_back_to_the_beginning(capsys: Any, tmp_path: Path) -> None:
    get_logger('before')
    launch_config.set_screen_format('default_with_timestamp')
    launch_config.level = logging.ERROR
    launch_config.log_dir = str(tmp_path)
    launch_config.reset()
    get_logger('after').info('text')
    assert capsys.readouterr().out == '[INFO] [after]: text\n'
    assert launch_config.level == logging.INFO
    assert not launch_config.log_dir.startswith(str(tmp_path))


def test_the_format_of_one_logger_can_be_taken_back() -> None:
    handler, logger = launch.logging.handlers.StreamHandler(), logging.getLogger('one')
    handler.setFormatter(logging.Formatter('usual: %(message)s'))
    record = logging.LogRecord('one', logging.INFO, 'a.py', 1, 'hello', None, None)
    log = [handler.format(record)]
    handler.setFormatterFor(logger, logging.Formatter('own: %(message)s'))
    log.append(handler.format(record))
    for _ in range(2):  # the second call has no effect
        handler.unsetFormatterFor(logger)
        log.append(handler.format(record))
    assert log == ['usual: hello', 'own: hello', 'usual: hello', 'usual: hello']
