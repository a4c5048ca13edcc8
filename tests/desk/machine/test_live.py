"""The live machine: its time, what it drops, whom it warns, and what happens when it gets another session."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from edulaunch.desk.machine.live import FORGET_EVERY_S, MESSAGES_KEPT, LiveMachine, end_programs, finish
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.runtime.session import Session


class Wire:
    """Stands for a real network, and keeps what the machine does with it."""

    is_on = True

    def __init__(self, session: Session) -> None:
        self.session = session
        self.log: list[str] = []

    def after_turn(self) -> None:
        self.log.append(f'turn at {self.session.sim.elapsed_s:.1f}')

    def off(self) -> bool:
        self.log.append('off')
        return True


@pytest.fixture
def session() -> Iterator[Session]:
    with Session() as made, streams_of_programs():
        yield made


def test_each_turn_is_passed_on_to_the_network_and_another_session_leaves_it(session: Session) -> None:
    machine = LiveMachine()
    machine.use(session, speed=2.0)
    wire: Any = Wire(session)
    machine.network = wire
    assert machine.time.speed == 2.0 and machine.has_joined
    session.sim.run(session.sim.now_ns + 10**9)
    machine.run_due()
    with Session() as other:
        machine.use(other)
        assert (machine.session, machine.time.speed, machine.network, machine.has_joined) == (other, 1.0, None, False)
    assert wire.log == ['turn at 1.0', 'off']


def test_warnings_reach_the_listeners_of_the_session_of_now_and_the_record(session: Session) -> None:
    machine, heard = LiveMachine(), []
    machine.use(session)
    machine.listeners.append(heard.append)
    machine.tell('the clock is behind')
    assert heard == ['the clock is behind']
    assert [(note.kind, note.text) for note in machine.recording().notes] == [('network', 'the clock is behind')]
    machine.use(session)
    machine.tell('again')
    assert heard == ['the clock is behind']


def test_old_messages_are_dropped_every_ten_seconds_and_only_where_a_limit_is_set(session: Session) -> None:
    session.launch('turtlesim', 'multisim.launch.py')
    keeping, dropping = LiveMachine(), LiveMachine(keep_s=2.0)
    for machine in (keeping, dropping):
        machine.use(session)
    topic = ('/turtlesim1/turtle1/pose', 'turtlesim/msg/Pose')
    dropped = []
    for seconds in (FORGET_EVERY_S - 0.1, 0.1, FORGET_EVERY_S - 0.1):
        session.run(seconds)
        keeping.forget()
        assert session.recorder.forgotten.get(topic, 0) == (dropped[-1] if dropped else 0)
        dropping.forget()
        dropped.append(session.recorder.forgotten.get(topic, 0))
    assert dropped[0] == 0 and dropped[1] == dropped[2] > MESSAGES_KEPT


def test_a_command_that_ignores_ctrl_c_is_killed_when_its_time_is_over(session: Session, tmp_path: Any) -> None:
    script = tmp_path / 'stubborn.py'
    script.write_text(
        'import signal, time\nsignal.signal(signal.SIGINT, lambda number, frame: print("no"))\nwhile True:\n    time.sleep(0.5)\n'
    )
    printed: list[str] = []
    late: list[bool] = []
    spec = ProcessSpec(argv=('python3', str(script)), name='stubborn')
    process: Any = session.host.start(spec, lambda stream, text: printed.append(text), lambda code: session.sim.stop())
    finish(session, process, 2.0, late.append)
    assert (session.sim.elapsed_s, late, printed) == (17.0, [False], ['no\n'])
    session.run(0.0)
    assert process.returncode == -9


def test_programs_that_end_by_ctrl_c_end_at_once(session: Session) -> None:
    launch = session.launch('turtlesim', 'multisim.launch.py')
    session.run(1.0)
    end_programs(session, [launch.process])
    assert launch.process.returncode is not None and session.sim.elapsed_s < 3.0
    assert session.graph.nodes == []
