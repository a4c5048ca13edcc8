"""Launch tests in plain pytest: what runs when, and what is said when it cannot."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.pytest_plugin.asked import uses_launch_pytest

from .conftest import PREAMBLE

Run = Callable[..., Any]
ALIVE = """
@launch_pytest.fixture
def alive():
    return launch.LaunchDescription([KeepAliveProc(), ReadyToTest()])
"""
SHARED = """
@pytest.fixture(scope='module')
def proc():
    return KeepAliveProc()
@launch_pytest.fixture(scope='module')
def shared(proc):
    return launch.LaunchDescription([proc, ReadyToTest()])
"""


def test_all_kinds_of_tests_run_beside_the_launch_or_after_it(inner: Run) -> None:
    done = inner(
        ALIVE
        + """
is_over = lambda service: service._is_idle() and service.event_loop is None
@pytest.mark.launch(fixture=alive)
def test_function(launch_service):
    assert not is_over(launch_service)
@pytest.mark.launch(fixture=alive)
async def test_coroutine(launch_service, event_loop):
    assert not is_over(launch_service) and asyncio.get_running_loop() is event_loop
@pytest.mark.launch(fixture=alive, shutdown=True)
def test_function_after(launch_service):
    assert is_over(launch_service)
@pytest.mark.launch(fixture=alive, shutdown=True)
async def test_coroutine_after(launch_service):
    assert is_over(launch_service)
@pytest.mark.launch(fixture=alive)
def test_generator(launch_service):
    assert not is_over(launch_service)
    yield
    assert is_over(launch_service)
@pytest.mark.launch(fixture=alive)
async def test_async_generator(launch_service):
    assert not is_over(launch_service)
    yield
    assert is_over(launch_service)
class TestInClass:
    @pytest.mark.launch(fixture=alive)
    async def test_method(self, launch_service, launch_context):
        assert launch_context is launch_service.context
def test_plain():
    assert True
"""
    )
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 8, done.text


def test_tests_share_a_launch_of_their_module_and_its_end_comes_last(inner: Run) -> None:
    done = inner(
        SHARED
        + """
@pytest.mark.launch(fixture=shared, shutdown=True)
def test_after(proc):
    assert proc.return_code is not None
@pytest.mark.launch(fixture=shared)
def test_two_parts(proc):
    assert proc.return_code is None
    yield
    assert proc.return_code is not None
@pytest.mark.launch(fixture=shared)
async def test_two_async_parts(proc):
    assert proc.return_code is None
    yield
    assert proc.return_code is not None
@pytest.mark.launch(fixture=shared)
def test_broken_before(proc):
    assert False
    yield
@pytest.mark.launch(fixture=shared)
def test_beside(proc):
    assert proc.return_code is None
"""
    )
    assert done.outcomes == [
        ('test_two_parts', 'passed'),
        ('test_two_async_parts', 'passed'),
        ('test_broken_before', 'failed'),
        ('test_beside', 'passed'),
        ('test_after', 'passed'),
        ('test_two_parts[shutdown_test]', 'passed'),
        ('test_two_async_parts[shutdown_test]', 'passed'),
        ('test_broken_before[shutdown_test]', 'skipped'),
    ], done.text


def test_time_of_a_test_file_is_simulated(inner: Run) -> None:
    done = inner(
        ALIVE
        + """
@pytest.mark.launch(fixture=alive)
def test_sleep():
    began = time.time()
    time.sleep(30)
    from time import monotonic, sleep
    sleep(30)
    assert time.time() - began == pytest.approx(60)
@pytest.mark.launch(fixture=alive)
def test_thread():
    heard = []
    thread = threading.Timer(20, lambda: heard.append(1))
    thread.start()
    thread.join()
    assert heard
@pytest.mark.launch(fixture=alive)
async def test_async_sleep(event_loop):
    began = event_loop.time()
    await asyncio.sleep(100)
    assert event_loop.time() - began == pytest.approx(100)
"""
    )
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 3, done.text


def test_fixtures_and_nodes_live_on_one_machine(inner: Run) -> None:
    done = inner("""
import rclpy
from std_msgs.msg import String
@pytest.fixture
def node():
    rclpy.init()
    yield rclpy.create_node('listener')
    rclpy.shutdown()
@launch_pytest.fixture
def talker():
    return launch.LaunchDescription([Node(package='demo_nodes_py', executable='talker')])
@pytest.mark.launch(fixture=talker)
def test_hears(node):
    heard = []
    node.create_subscription(String, 'chatter', lambda message: heard.append(message.data), 10)
    while len(heard) < 2:
        rclpy.spin_once(node, timeout_sec=5)
    assert heard == ['Hello World: 0', 'Hello World: 1']
""")
    assert done.outcomes == [('test_hears', 'passed')], done.text


def test_launch_fixtures_may_be_parametrized_and_yield(inner: Run) -> None:
    done = inner("""
ended = []
@launch_pytest.fixture(params=['a', 'b'], name='told')
def tell(request, launch_service):
    yield launch.LaunchDescription([KeepAliveProc()]), request.param
    ended.append(launch_service.event_loop is None)
@pytest.mark.launch(fixture=tell)
@pytest.mark.parametrize('number', [1, 2])
def test_values(told, number):
    assert told[1] in 'ab'
def test_ended():
    assert ended == [True] * 4
""")
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 5, done.text


@pytest.mark.parametrize(
    ('text', 'outcome', 'said'),
    [
        (
            ALIVE + '@pytest.mark.launch\ndef test_it(): pass',
            'skipped',
            '"fixture" keyword argument is required in a pytest.mark.launch() decorator',
        ),
        (
            '@pytest.fixture\ndef plain(): pass\n@pytest.mark.launch(fixture=plain)\ndef test_it(): pass',
            'skipped',
            "must be a launch fixture: decorate 'plain' with @launch_pytest.fixture",
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive, shutdown=True)\ndef test_it(): yield',
            'skipped',
            'generator or async generator based launch test items cannot be marked with shutdown=True',
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive)\ndef test_it():\n    yield\n    yield',
            'failed',
            'launch tests using a generator function must stop iteration after yielding once',
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive)\nasync def test_it():\n    yield\n    yield',
            'failed',
            'launch tests using an async gen function must stop iteration after yielding once',
        ),
        (
            '@launch_pytest.fixture\ndef empty(): pass\n@pytest.mark.launch(fixture=empty)\ndef test_it(): pass',
            'error',
            "When running launch_pytest fixture 'empty': return value must be either a launch description or a sequence whose first "
            'item is a launch description\n  help: it is None',
        ),
        (
            '@launch_pytest.fixture\ndef two(): return launch.LaunchDescription([ReadyToTest(), ReadyToTest()])\n'
            '@pytest.mark.launch(fixture=two)\ndef test_it(): pass',
            'error',
            'containing only one ReadyToTest action',
        ),
        (
            '@launch_pytest.fixture\ndef bad(): return launch.LaunchDescription([Node(package="nowhere", executable="x"), ReadyToTest()])\n'
            '@pytest.mark.launch(fixture=bad)\ndef test_it(): pass',
            'error',
            "fixture 'bad': the launch ended before ReadyToTest was reached: PackageNotFoundError: \"package 'nowhere' not found",
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive)\ndef test_it(): threading.Event().wait()',
            'failed',
            'the test did not come to its end: it was still waiting after 600.0 s of simulated time',
        ),
        (
            '@launch_pytest.fixture(auto_shutdown=False)\ndef stays(): return launch.LaunchDescription([KeepAliveProc()])\n'
            '@pytest.mark.launch(fixture=stays, shutdown=True)\ndef test_it(): pass',
            'failed',
            'the launch did not come to its end',
        ),
    ],
)
def test_what_goes_wrong_is_told(inner: Run, text: str, outcome: str, said: str) -> None:
    done = inner(text)
    assert done.outcomes[0] == ('test_it', outcome)
    assert said in done.text


def test_fixtures_of_one_scope_share_a_launch(inner: Run) -> None:
    done = inner(
        SHARED
        + """
@launch_pytest.fixture(scope='module')
def more(proc):
    return launch.LaunchDescription([KeepAliveProc()])
@pytest.mark.launch(fixture=shared)
def test_one(launch_service):
    assert launch_service.event_loop is not None
@pytest.mark.launch(fixture=more)
def test_other(proc):
    assert proc.return_code is None
"""
    )
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 2, done.text


def test_a_launch_may_be_left_to_end_by_itself(inner: Run) -> None:
    done = inner("""
@launch_pytest.fixture(auto_shutdown=False)
def short():
    return launch.LaunchDescription([TimerAction(period=7.0, actions=[])])
@pytest.mark.launch(fixture=short)
async def test_it(event_loop):
    global began
    began = event_loop.time()
    yield
    assert event_loop.time() - began == pytest.approx(7.0)
""")
    assert done.outcomes == [('test_it', 'passed')], done.text


def test_a_conftest_may_hold_the_fixtures(inner: Run) -> None:
    done = inner(
        ALIVE
        + """
@pytest.mark.launch(fixture=alive)
def test_it(from_conftest):
    assert from_conftest == 'launch_pytest'
""",
        conftest='import launch_pytest, pytest\n@pytest.fixture\ndef from_conftest(): return launch_pytest.__name__\n',
    )
    assert done.outcomes == [('test_it', 'passed')], done.text


@pytest.mark.parametrize(
    ('source', 'imported', 'answer'),
    [
        (b'import launch_pytest', False, True),
        (b'@pytest.mark.launch(fixture=f)\ndef test(): ...', True, True),
        (b"@pytest.mark.launch('a browser')\ndef test(): ...", False, False),
        (b'TEXT = "import launch_pytest"', True, False),
        (b'def test_plain(): ...', True, False),
    ],
)
def test_a_mark_of_somebody_else_is_left_alone(
    source: bytes, imported: bool, answer: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not imported:
        monkeypatch.delitem(sys.modules, 'launch_pytest', raising=False)
    else:
        monkeypatch.setitem(sys.modules, 'launch_pytest', sys)
    assert uses_launch_pytest(source) is answer


def test_a_test_file_sees_its_workspace(inner: Run, tmp_path: Path) -> None:
    package = tmp_path / 'pkg'
    package.mkdir()
    (tmp_path / 'package.xml').write_text(
        '<package format="3"><name>pkg</name><version>0.0.1</version><description>d</description><maintainer email="a@b.c">m'
        '</maintainer><license>MIT</license><export><build_type>ament_python</build_type></export></package>'
    )
    (tmp_path / 'setup.py').write_text(
        "from setuptools import setup\nsetup(name='pkg', version='0.0.1', packages=['pkg'], "
        "entry_points={'console_scripts': ['wait = pkg.node:main']})\n"
    )
    (tmp_path / 'setup.cfg').write_text('[develop]\nscript_dir=$base/lib/pkg\n[install]\ninstall_scripts=$base/lib/pkg\n')
    (package / '__init__.py').write_text('')
    (package / 'node.py').write_text('import time\ndef main():\n    time.sleep(4)\n    return 3\n')
    done = inner("""
from pkg.node import main
@pytest.fixture
def proc():
    return Node(package='pkg', executable='wait')
@launch_pytest.fixture
def waiting(proc):
    return launch.LaunchDescription([proc])
@pytest.mark.launch(fixture=waiting)
def test_it(proc, launch_context):
    began = time.time()
    assert main() == 3 and time.time() - began == 4
    assert tools.wait_for_exit_sync(launch_context, proc, timeout=1) and proc.return_code == 3
""")
    assert done.outcomes == [('test_it', 'passed')], done.text


@pytest.mark.whole
def test_a_run_of_its_own_finds_ros_for_conftests_and_inner_runs_do_not_disturb_each_other(tmp_path: Path) -> None:
    (tmp_path / 'conftest.py').write_text('from std_msgs.msg import String\nimport launch_pytest\n')
    (tmp_path / 'test_outer.py').write_text(f"""
pytest_plugins = ['pytester']
SOURCE = {PREAMBLE + ALIVE!r} + '''
@pytest.mark.launch(fixture=alive, shutdown=True)
def test_it(launch_service):
    assert launch_service._is_idle()
'''
def test_first(pytester):
    pytester.makepyfile(SOURCE)
    pytester.runpytest('-p', 'edulaunch.pytest_plugin').assert_outcomes(passed=1)
test_second = test_first
""")
    here = str(Path(__file__).resolve().parents[2])
    env = {**os.environ, 'PYTHONPATH': here, 'PYTEST_DISABLE_PLUGIN_AUTOLOAD': '1', 'PYTHONDONTWRITEBYTECODE': '1'}
    command = [sys.executable, '-m', 'pytest', '-q', '-p', 'edulaunch.pytest_plugin', '-p', 'no:cacheprovider', str(tmp_path)]
    done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert '2 passed' in done.stdout, done.stdout + done.stderr
