"""Wrong advice on files of repositories of an eighth draw, each as a small case of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.advice.test_found_in_draws import WALKER, launch, program, write
from tests.advice.test_found_on_28_november import report

ASKS = """        self.client = self.create_client(Empty, 'clear')
        self.create_timer(1.0, self.ask)

    def ask(self):
        future = self.client.call_async(Empty.Request())
{waits}        answer = future.result()
        print(answer)

    def arrived(self, future):
        return future.done()
"""


@pytest.mark.parametrize(
    ('waits', 'is_told'), [('', True), ('        if not self.arrived(future):\n            return\n', False)]
)
def test_a_future_that_a_helper_gets_may_have_its_result(
    waits: str, is_told: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sim = "Node(package='turtlesim', executable='turtlesim_node')"
    write(
        tmp_path,
        walker_py=program(ASKS.format(waits=waits), 'from std_srvs.srv import Empty'),
        main_launch_py=launch(sim, WALKER),
    )
    printed = report(capsys, tmp_path / 'main.launch.py', code=1 if is_told else 0)
    assert ('future.result() returns None here' in printed) == is_told


@pytest.mark.parametrize(
    ('between', 'is_told'), [("    'Select one: lidar_a, LIDAR_B'\n", False), ("    'Select a device'\n", True), ('', True)]
)
def test_an_action_that_a_text_of_the_file_offers_is_left_out_on_purpose(
    between: str, is_told: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sims = ''.join(f"    lidar_{one} = Node(package='turtlesim', executable='turtlesim_node', name='{one}')\n" for one in 'ab')
    head = 'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\ndef generate_launch_description():\n'
    document = '    """Start lidar_b of the robot."""\n'
    (tmp_path / 'main.launch.py').write_text(f'{head}{document}{sims}{between}    return LaunchDescription([lidar_a])\n')
    printed = report(capsys, tmp_path / 'main.launch.py', code=1 if is_told else 0)
    assert ('the Node lidar_b is never added to the launch description' in printed) == is_told
