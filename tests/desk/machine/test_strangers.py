"""Whoever is not the owner gets nothing, and nothing that comes over a connection harms the machine."""

from __future__ import annotations

import os
import random
import shutil
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

import edulaunch
from edulaunch.desk.machine import wire
from edulaunch.desk.machine.client import hello
from edulaunch.desk.machine.place import Address, UnsafePlace, folder, installation, read_address, write_address
from edulaunch.runtime.framing import frame
from tests.desk.machine.conftest import desk_in
from tests.desk.machine.shells import PATIENCE_S, Desk

NOBODY = 65534


def connected(address: Address) -> socket.socket:
    client = socket.socket(socket.AF_UNIX)
    client.settimeout(PATIENCE_S)
    client.connect(address.place)
    return client


def answer(client: socket.socket) -> bytes:
    """Everything that the machine says until it closes."""
    said = b''
    try:
        while data := client.recv(4096):
            said += data
    except ConnectionError:
        pass
    return said


@pytest.fixture
def machine(shared_desk: Desk) -> Address:
    """The machine of the shared desk."""
    found = read_address(str(shared_desk.place), '0')
    assert found is not None
    return found


@pytest.mark.parametrize(
    'said',
    [
        b'GET / HTTP/1.1\r\n\r\n',
        frame(wire.HELLO, b'wrong token'),
        hello('0' * 32, ['ros2', 'topic', 'list']),
        frame(wire.SIGNAL, b'9'),
        (1 << 31).to_bytes(4, 'little') + b'H',
        frame(wire.HELLO, b'\xff\0' * 100),
    ],
)
def test_who_does_not_know_the_token_gets_nothing(shared_desk: Desk, machine: Address, said: bytes) -> None:
    with connected(machine) as client:
        client.sendall(said)
        assert answer(client) == b''


@pytest.mark.parametrize('fields', [[], ['/'], ['/', '80', '24', '111', '99999', 'ros2'], ['/', 'x', '24', '111', '1', 'ros2']])
def test_a_hello_without_sense_closes_the_connection(shared_desk: Desk, machine: Address, fields: list[str]) -> None:
    with connected(machine) as client:
        client.sendall(frame(wire.HELLO, wire.pack([machine.token, *fields])))
        assert wire.EXIT not in answer(client)[:1]
    assert shared_desk.said('node list') == '/talker\n'


def test_two_hundred_connections_that_send_garbage_or_die(shared_desk: Desk, machine: Address) -> None:
    chance = random.Random(13)
    good = hello(machine.token, ['ros2', 'topic', 'echo', '/chatter'])
    clients = []
    for number in range(200):
        client = connected(machine)
        said = [
            chance.randbytes(chance.randrange(1, 5000)),
            good[: chance.randrange(len(good))],
            good,
            good + chance.randbytes(50),
        ]
        client.sendall(said[number % 4])
        clients.append(client)
    for client in chance.sample(clients, len(clients)):
        client.close()
    assert shared_desk.said('node list') == '/talker\n'


def test_the_folder_and_all_in_it_is_its_owners_alone(shared_desk: Desk, machine: Address) -> None:
    place = shared_desk.place
    modes = {path.name: path.stat().st_mode & 0o777 for path in (place, *place.iterdir())}
    assert {name: mode & 0o077 for name, mode in modes.items()} == dict.fromkeys(modes, 0)


@pytest.mark.skipif(os.name != 'posix' or os.geteuid() != 0, reason='only root can become somebody else')
def test_another_user_is_kept_out_even_with_the_token(shared_desk: Desk, machine: Address) -> None:
    code = (
        'import os, socket, sys; data = sys.stdin.buffer.read(); client = socket.socket(socket.AF_UNIX); '
        f'os.chdir({os.path.dirname(machine.place)!r}); os.setgid({NOBODY}); os.setuid({NOBODY}); '
        f'client.connect({os.path.basename(machine.place)!r}); client.sendall(data); print(client.recv(100))'
    )

    def stranger() -> subprocess.CompletedProcess[bytes]:
        said = hello(machine.token, ['ros2', 'topic', 'list'])
        return subprocess.run([sys.executable, '-c', code], input=said, capture_output=True, timeout=PATIENCE_S)

    assert b'PermissionError' in stranger().stderr
    os.chmod(os.path.dirname(machine.place), 0o755)
    os.chmod(machine.place, 0o777)  # as if somebody had opened the doors
    done = stranger()
    os.chmod(machine.place, 0o600)
    os.chmod(os.path.dirname(machine.place), 0o700)
    assert done.stdout.strip() == b"b''" or b'ConnectionResetError' in done.stderr or b'BrokenPipeError' in done.stderr
    assert shared_desk.said('node list') == '/talker\n'


@pytest.mark.parametrize('what', ['mode', 'link', 'file'])
def test_a_folder_that_others_may_enter_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, what: str) -> None:
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(tmp_path))
    place = tmp_path / f'edulaunch-{installation()}'
    if what == 'mode':
        place.mkdir()
        place.chmod(0o755)
    elif what == 'link':
        (tmp_path / 'other').mkdir(mode=0o700)
        place.symlink_to(tmp_path / 'other')
    else:
        place.touch(0o700)
    with pytest.raises(UnsafePlace, match='other users can enter'):
        folder()


@pytest.mark.parametrize('text', ['', 'unix', 'unix\n/nowhere\ntoken\nx\nterminals\n', 'unix\n/nowhere\ntoken\n1\nterminals\n'])
def test_an_address_that_leads_nowhere_is_no_hindrance(desk: Desk, text: str) -> None:
    place = desk.place
    place.mkdir(mode=0o700)
    (place / 'domain-0').write_text(text)
    assert desk.said('topic list') == '/parameter_events\n/rosout\n'


def test_a_machine_that_was_killed_is_followed_by_another(desk: Desk) -> None:
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Publishing')
    os.kill(desk.machine_pid(), signal.SIGKILL)
    assert talker.end() == 1 and 'the machine has ended' in talker.output
    assert desk.said('node list') == ''


def test_another_installation_has_its_own_machine(desk: Desk, tmp_path: Path) -> None:
    """The machine of a second clone has the packages of the second clone."""
    shutil.copytree(
        Path(edulaunch.__file__).parent, tmp_path / 'clone' / 'edulaunch', ignore=shutil.ignore_patterns('__pycache__')
    )
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    assert desk.said('node list', PYTHONPATH=str(tmp_path / 'clone')) == ''
    assert desk.said('node list') == '/talker\n'
    assert len(list(desk.runtime.glob('edulaunch-*'))) == 2


def test_an_address_is_replaced_as_a_whole(tmp_path: Path) -> None:
    address = Address('unix', '/a', 'token', 7, 'terminals')
    write_address(str(tmp_path), '3', address)
    found = read_address(str(tmp_path), '3')
    assert found is not None and found.lines() == address.lines() and read_address(str(tmp_path), '4') is None
    assert [path.name for path in tmp_path.iterdir()] == ['domain-3']


def test_without_unix_sockets_a_port_of_the_loopback_serves_who_knows_the_token(tmp_path: Path) -> None:
    for desk in desk_in(tmp_path, runtime='r' * 100):  # longer than the path of a socket may be
        desk.ros2('run demo_nodes_py talker').until('Publishing')
        assert desk.said('node list') == '/talker\n'
        address = read_address(str(desk.place), '0')
        assert address is not None and address.kind == 'tcp'
        for said in (b'\0' * 100, hello('guess', ['ros2', 'node', 'list'])):
            with socket.create_connection(('127.0.0.1', int(address.place)), timeout=PATIENCE_S) as client:
                client.sendall(said)
                assert answer(client) == b''
