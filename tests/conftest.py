"""All tests see the underlay, as after `edulaunch.source()`, and leave the environment as they found it."""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings
from hypothesis.internal.conjecture import providers

import edulaunch
from edulaunch.engine.sim.task import AmbientTask, current_task
from tests.house import EXAMPLES
from tests.kinds import ALL_TESTS, KINDS, UnitTestsStartNoPython, has_none_of, kinds_of

edulaunch.source()
os.environ['EDULAUNCH_LANG'] = 'en'  # whoever runs the tests may read another language
# Whoever starts the tests in the background, or with nohup, has signals ignored: what is tested here is that they arrive.
for name, usual in (('SIGINT', signal.default_int_handler), ('SIGHUP', signal.SIG_DFL), ('SIGQUIT', signal.SIG_DFL)):
    number = getattr(signal, name, None)
    if number is not None and signal.getsignal(number) is signal.SIG_IGN:
        signal.signal(number, usual)
HERE = (Path(__file__).parent, Path(__file__).parents[1])
# Each module is collected and frozen at its end: in between the collector found little, and took a tenth of the time.
gc.set_threshold(20_000, 20, 20)
settings.register_profile('repository', deadline=None, derandomize=True, max_examples=EXAMPLES)  # the same in every run
settings.load_profile('repository')
# Else hypothesis reads the source of every module that is loaded by then, and tries its numbers and texts: a property would meet
# other examples beside other tests.
providers._get_local_constants = providers.Constants


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(UnitTestsStartNoPython())


def pytest_report_header() -> str:
    """Say what a run of all unit tests leaves out."""
    return f'unit tests; left out unless their folder or their mark is named: {", ".join(f"-m {kind}" for kind in KINDS)}'


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Whoever asks for some kinds does not wait until all other files are imported, once in each worker."""
    return True if collection_path.is_file() and has_none_of(collection_path, config.option.markexpr) else None


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """What takes its time is left to those who name it, and to a step of `.ci/run`."""
    config.stash[ALL_TESTS] = list(items)
    if config.option.markexpr or any(Path(word.partition('::')[0]).resolve() not in HERE for word in config.args):
        return
    left_out = [item for item in items if kinds_of(item)]
    items[:] = [item for item in items if not kinds_of(item)]
    config.hook.pytest_deselected(items=left_out)


@pytest.fixture(autouse=True)
def same_environment() -> Iterator[None]:
    """Outside a simulation launch acts on this program's own environment variables: put them back after each test. A command that
    ends soon switches the collector off (`edulaunch explain`): for the tests after it, it is on again.
    """
    before = dict(os.environ)
    yield
    gc.enable()
    if dict(os.environ) != before:
        os.environ.clear()
        os.environ.update(before)


@pytest.fixture(autouse=True, scope='session')
def no_machine_of_somebody_else(tmp_path_factory: pytest.TempPathFactory) -> None:
    """What runs in the terminals of whoever runs the tests is not found by them."""
    os.environ['XDG_RUNTIME_DIR'] = str(tmp_path_factory.mktemp('run'))


@pytest.fixture(autouse=True, scope='module')
def no_parked_tasks_left() -> Iterator[None]:
    """Unwind here what a test module left parked: when the collector does that inside `ast.parse`, CPython 3.11 trips over it."""
    yield
    here = current_task()
    paced = here.real_threads if isinstance(here, AmbientTask) else None
    assert paced is None or not paced.are_here(), 'a thread was left: in all tests after this one simulated time is real time'
    gc.collect()
    gc.freeze()  # what is left stays: the next collection need not look at it again
