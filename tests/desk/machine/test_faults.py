"""A fault of the computer costs one terminal at most, never the machine, and is a sentence to the user."""

from __future__ import annotations

import errno
import io
import os
import selectors
import socket
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.desk.machine import client, heartbeat, serving
from edulaunch.desk.machine.live import LiveMachine
from edulaunch.desk.machine.place import Address, listen
from edulaunch.desk.machine.server import Server
from edulaunch.errors import FAULTS, fault_text
from edulaunch.runtime.session import Session

HELP = '\n  help: close other programs or free disk space, and type the command again'


def failing(number: int) -> Callable[..., Any]:
    """A call that this computer cannot do."""

    def call(*_: Any, **__: Any) -> Any:
        raise OSError(number, os.strerror(number))

    return call


class Desk:
    """A machine in this process, with its socket."""

    def __init__(self, place: Path) -> None:
        self.terminals: list[socket.socket] = []
        self.session, machine = Session(), LiveMachine()
        machine.use(self.session)
        listener, self.address = listen(str(place), '0', 'terminals')
        self.server = Server(machine, listener, self.address.token)

    def terminal(self) -> socket.socket:
        """A terminal that has said which command it wants."""
        found = socket.socket(socket.AF_UNIX)
        self.terminals.append(found)
        found.connect(self.address.place)
        found.sendall(client.hello(self.address.token, ['machine', 'status'], keyboard=False))
        return found

    def answer(self, terminal: socket.socket) -> bytes:
        """What the machine says to it until its end."""
        for _ in range(20):
            self.server.run_due()
            self.server.listen(0.0)
        terminal.setblocking(False)
        try:
            return terminal.recv(1 << 16)
        except BlockingIOError:
            return b'nothing'
        except ConnectionResetError:
            return b''

    def close(self) -> None:
        for terminal in self.terminals:
            terminal.close()
        self.server.close()
        self.session.close()


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    found = Desk(tmp_path)
    yield found
    found.close()


@pytest.mark.parametrize('number', FAULTS, ids=errno.errorcode.get)
@pytest.mark.parametrize('call', ['accepting', 'asking who it is', 'asking for signals', 'watching'])
def test_a_terminal_that_cannot_be_accepted_does_not_end_the_machine(
    desk: Desk, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], call: str, number: int
) -> None:
    monkeypatch.setattr(sys, '__stderr__', complaints := io.StringIO())
    with monkeypatch.context() as patch:
        if call == 'accepting':
            patch.setattr(socket.socket, 'accept', failing(number))
        elif call == 'asking who it is':
            patch.setattr(socket.socket, 'getsockopt', failing(number))
        elif call == 'asking for signals':
            patch.setattr(desk.server, 'on_accept', failing(number))
        else:
            patch.setattr(selectors.DefaultSelector, 'register', failing(number))
        unlucky = desk.terminal()
        first = desk.answer(unlucky)
    assert first == (b'nothing' if call == 'accepting' else b'')
    assert complaints.getvalue().count('could not accept a terminal: ') == (call != 'accepting')
    assert b'machine: process' in desk.answer(desk.terminal())
    assert b'machine: process' in desk.answer(unlucky) if call == 'accepting' else not desk.server.has_connections()


@pytest.mark.parametrize('call', ['send', 'recv'])
def test_a_connection_that_breaks_closes_one_terminal(desk: Desk, monkeypatch: pytest.MonkeyPatch, call: str) -> None:
    desk.terminal()
    desk.server.listen(0.0)
    with monkeypatch.context() as patch:
        patch.setattr(socket.socket, call, failing(errno.ENOBUFS))
        for _ in range(3):
            desk.server.listen(0.0)
            desk.server.run_due()
    assert not desk.server.has_connections()
    assert b'machine: process' in desk.answer(desk.terminal())


def test_a_machine_without_threads_or_files_says_so_in_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def no_thread(*_: Any, **__: Any) -> None:
        raise RuntimeError("can't start new thread")

    for fault, text in (
        (no_thread, "The machine could not start: can't start new thread"),
        (failing(errno.EMFILE), 'The machine could not start: [Errno 24] Too many open files'),
    ):
        monkeypatch.setattr(serving, 'started', fault)
        monkeypatch.setattr(serving, 'read_address', lambda *_: Address('unix', '', 'token', os.getpid(), 'terminals'))
        monkeypatch.setattr(serving.socket, 'socket', lambda **_: None)
        monkeypatch.setattr(serving.signal, 'signal', lambda *_: None)
        monkeypatch.setattr(sys, 'argv', ['serving', str(tmp_path), '0'])
        with pytest.raises(SystemExit) as end:
            serving.main()
        assert end.value.code == text


def test_a_heartbeat_that_cannot_be_sent_is_followed_by_the_next(monkeypatch: pytest.MonkeyPatch) -> None:
    answers = [errno.EAGAIN, errno.ENOMEM, errno.EIO, errno.EPIPE]
    monkeypatch.setattr(heartbeat.time, 'sleep', lambda seconds: None)
    monkeypatch.setattr(heartbeat.os, 'write', lambda *_: failing(answers.pop(0))())
    monkeypatch.setattr(heartbeat.signal, 'pthread_sigmask', lambda *_: None)

    class Quiet:
        rounds, is_listening = 0, True

    heartbeat.Heartbeat(Quiet())._beat()  # type: ignore[arg-type]
    assert answers == []


@pytest.mark.parametrize('number', [errno.EMFILE, errno.ENOSPC, errno.EAGAIN], ids=errno.errorcode.get)
@pytest.mark.parametrize('call', ['socket.socket', 'os.open', 'os.pipe', 'os.fork', 'os.replace'])
def test_a_machine_that_cannot_be_started_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], call: str, number: int
) -> None:
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(tmp_path))
    if call == 'os.replace':
        monkeypatch.setattr('edulaunch.desk.machine.starting._spawn', lambda *_: (0, 0))
    monkeypatch.setattr(call, failing(number))
    assert client.run(['ros2', 'topic', 'list']) == 1
    said = capsys.readouterr()
    assert said.err == f'error: cannot reach or start the machine of your terminals: {os.strerror(number)}{HELP}\n'


def test_a_connection_that_breaks_at_the_terminal_is_a_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    ours, theirs = socket.socketpair()
    address = Address('unix', '', '', 0, 'terminals')
    monkeypatch.setattr(client, 'connect', lambda number, *, start: (ours, address))
    monkeypatch.setattr(socket.socket, 'send', failing(errno.ENOBUFS))
    with theirs:
        assert client.run(['ros2', 'topic', 'list']) == 1
    assert capsys.readouterr().err == f'error: the connection to the machine broke: No buffer space available{HELP}\n'


def test_a_wake_up_without_data_is_no_end(monkeypatch: pytest.MonkeyPatch) -> None:
    ours, theirs = socket.socketpair()
    address = Address('unix', '', '', 0, 'terminals')
    monkeypatch.setattr(client, 'connect', lambda number, *, start: (ours, address))
    recv, calls = socket.socket.recv, []

    def spurious(self: socket.socket, *size: Any) -> bytes:
        calls.append(1)
        if len(calls) < 3:
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        return recv(self, *size)

    monkeypatch.setattr(socket.socket, 'recv', spurious)
    with theirs:
        from edulaunch.desk.machine import wire
        from edulaunch.runtime.framing import frame

        theirs.sendall(frame(wire.EXIT, b'7'))
        assert client.run(['ros2', 'topic', 'list']) == 7


def test_a_command_of_the_machine_that_finds_no_file_left_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    printed: list[str] = []
    with Session(console=lambda stream, text: printed.append(text)) as session:
        monkeypatch.setattr('edulaunch.desk.cli.ros2.commands.command_line', failing(errno.EMFILE))
        from edulaunch.engine.processes.spec import ProcessSpec

        program = session.host.start(
            ProcessSpec(argv=('ros2', 'topic', 'list'), name='ros2'), lambda stream, text: printed.append(text)
        )
        session.run(1.0)
    assert program.returncode == 1
    assert ''.join(printed) == f'error: {fault_text(OSError(errno.EMFILE, os.strerror(errno.EMFILE)))}\n'


def test_a_verb_that_finds_no_file_left_says_so(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr('edulaunch.desk.cli.main.load', lambda verb: (lambda parser: None, failing(errno.EMFILE)))
    assert main(['rosdep']) == 1
    assert capsys.readouterr().err == f'error: Too many open files{HELP}\n'
