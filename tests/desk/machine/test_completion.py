"""The Tab key sees what is on the machine."""

from __future__ import annotations

import sys

from tests.desk.machine.shells import Desk, Shell


def test_the_tab_key_offers_topics_and_nodes_of_the_running_machine(shared_desk: Desk) -> None:
    program = [sys.executable, '-c', 'import sys; from edulaunch.desk.cli.main import main; sys.exit(main())']
    for line, offered in (
        ('ros2 topic echo /ch', '/chatter'),
        ('ros2 node info /', '/talker'),
        ('ros2 param get /talker use', 'use_sim_time'),
    ):
        shell = Shell('completion', 'zsh', '--line', line, cwd=shared_desk.folder, env=shared_desk.env, program=program)
        shared_desk.shells.append(shell)
        assert shell.end() == 0
        assert shell.output.split() == [offered]
