"""A notebook and terminals beside it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from tests.desk.machine.conftest import desk_in
from tests.desk.machine.shells import PATIENCE_S, Desk

UP = '\x1b[A'


class Notebook:
    """A kernel on the machine of a desk."""

    def __init__(self, desk: Desk) -> None:
        manager = pytest.importorskip('jupyter_client').KernelManager()
        manager.start_kernel(env=desk.env, cwd=str(desk.folder))
        self._manager = manager
        self._client = manager.client()
        self._client.start_channels()
        self._client.wait_for_ready(timeout=PATIENCE_S)
        assert self.run('%load_ext edulaunch.jupyter') == ''

    def run(self, code: str) -> str:
        """Execute a cell; what it prints."""
        said: list[str] = []

        def hear(message: Any) -> None:
            if message['msg_type'] == 'stream':
                said.append(message['content']['text'])
            elif message['msg_type'] == 'error':
                said.append(message['content']['ename'])

        self._client.execute_interactive(code, timeout=PATIENCE_S, output_hook=hear)
        return ''.join(said)

    def close(self) -> None:
        """Shut the kernel down."""
        self._client.stop_channels()
        self._manager.shutdown_kernel(now=True)


@pytest.fixture(scope='module')
def desk(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Desk]:
    yield from desk_in(tmp_path_factory.mktemp('desk'))


@pytest.fixture(scope='module')
def notebook(desk: Desk) -> Iterator[Notebook]:
    """A kernel that has run nothing yet when the first test comes."""
    found = Notebook(desk)
    yield found
    found.close()


def test_four_terminals_and_a_notebook(desk: Desk, notebook: Notebook) -> None:
    launch = desk.ros2('launch turtlesim multisim.launch.py')
    launch.until('[turtlesim_node-2]: process started')
    teleop = desk.ros2('run turtlesim turtle_teleop_key --ros-args -r __ns:=/turtlesim1')
    teleop.until("'Q' to quit.")
    echo = desk.ros2('topic echo /turtlesim1/turtle1/cmd_vel')
    while 'linear' not in echo.output:
        teleop.type(UP)
        echo.read(0.1)
    second = desk.ros2('launch demo_nodes_cpp talker_listener_launch.py')
    second.until('I heard')
    nodes = notebook.run('%ros2 node list')
    assert {'/turtlesim1/turtlesim', '/turtlesim2/turtlesim', '/turtlesim1/teleop_turtle', '/talker', '/listener'} <= set(
        nodes.split()
    )
    for shell, gone in (
        (teleop, '/turtlesim1/teleop_turtle'),
        (echo, ''),
        (second, '/talker'),
        (launch, '/turtlesim1/turtlesim'),
    ):
        shell.send(9)
        shell.end()
        nodes = desk.said('node list')
        assert gone not in nodes.split(), nodes
    assert nodes == ''


def test_terminals_see_what_a_lesson_started_and_the_other_way_round(desk: Desk, notebook: Notebook) -> None:
    assert 'process started' in notebook.run('run = %ros2 launch turtlesim multisim.launch.py --for 1')
    assert desk.said('node list') == '/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n'
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Hello World: 1')
    assert notebook.run('%ros2 node list') == '/talker\n/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n'
    notebook.run('%ros2 launch turtlesim multisim.launch.py --for 1')  # beside: somebody is there
    assert '/talker\n' in notebook.run('%ros2 node list')
    before = talker.output.count('Publishing')
    talker.until(lambda output: output.count('Publishing') > before)
    talker.type('\x03')
    talker.end()
    assert notebook.run('run.duration_s') == ''
    notebook.run(
        'before = %recording\nimport time; time.sleep(0.1)\nafter = %recording\nassert before.duration_s == after.duration_s'
    )
