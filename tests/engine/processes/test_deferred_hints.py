"""Help below errors, of several commands on one machine."""

from __future__ import annotations

from pathlib import Path

from edulaunch.engine.processes import ProcessSpec
from edulaunch.runtime.session import Session

LAUNCH = 'from launch import LaunchDescription\nfrom launch_ros.actions import Node\ndef generate_launch_description():\n    {}\n'
NODE = "Node(package='turtlesim', executable='turtlesim_node'{})"


def test_an_error_that_ends_with_the_same_line_as_an_earlier_one_has_help_of_its_own(tmp_path: Path) -> None:
    told: list[str] = []
    with Session() as session:
        for number, body in enumerate(
            (
                f'return LaunchDescription([{NODE.format("")} {NODE.format("")}])',
                f'return LaunchDescription({NODE.format("")}, {NODE.format("")})',
                f'return LaunchDescription([{NODE.format(", parameters={}")}])',
                f'return LaunchDescription([{NODE.format(", parameters=1")}])',
            )
        ):
            (tmp_path / 'a.launch.py').write_text(LAUNCH.format(body))
            spec = ProcessSpec(argv=('ros2', 'launch', 'a.launch.py'), name=f'ros2-{number}', cwd=str(tmp_path))
            session.host.start(spec, lambda _, text: told.extend(line for line in text.splitlines() if 'help: ' in line))
            session.run(1)
    assert [line.partition('(IncludeLaunchDescription): ')[2] for line in told] == [
        'a comma is missing in this line, or at the end of the line above; write a comma between the two values',
        'LaunchDescription does not accept these arguments without names; put the arguments into one list: LaunchDescription([..., ...])',
        'the value of parameters= cannot be of type dict; put the value into a list: parameters=[...]',
        'the value of parameters= cannot be of type int; put the value into a list: parameters=[...]',
    ]
