"""The borrowed parts of osrf_pycommon."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest
from osrf_pycommon.process_utils import (
    AsyncSubprocessProtocol,
    async_execute_process,
    execute_process,
    execute_process_split,
    get_loop,
    which,
)
from osrf_pycommon.terminal_color import remove_ansi_escape_sequences


def test_one_loop_for_a_process_until_it_is_closed() -> None:
    loop = get_loop()
    assert get_loop() is loop
    loop.close()
    other = get_loop()
    assert other is not loop
    other.close()


def test_programs_are_found_on_the_path_of_the_process(fresh_simulation: Any) -> None:
    assert which('sh') is not None
    fresh_simulation.env['PATH'] = '/nowhere'
    assert which('sh') is None


def test_colours_are_removed() -> None:
    assert remove_ansi_escape_sequences('\x1b[31mred\x1b[0m and \x1b[1;4mbold\x1b[m') == 'red and bold'


@pytest.mark.parametrize('new_loop', [get_loop, asyncio.new_event_loop])
def test_programs_run_on_any_loop(new_loop: Any) -> None:
    told: list[object] = []

    class Protocol(AsyncSubprocessProtocol):
        def on_stdout_received(self, data: bytes) -> None:
            told.append(data)

        def on_process_exited(self, returncode: int) -> None:
            told.append(returncode)

    async def run() -> int:
        transport, protocol = await async_execute_process(Protocol, ['sh', '-c', 'echo out; echo err >&2; exit 3'])
        code: int = await protocol.complete
        assert transport.get_returncode() == code
        transport.close()
        return code

    loop = new_loop()
    assert loop.run_until_complete(run()) == 3
    told.remove(3)
    assert sorted(b''.join(told).splitlines()) == [b'err', b'out']  # type: ignore[arg-type]
    loop.close()


def test_missing_program_cannot_be_awaited() -> None:
    loop = get_loop()
    with pytest.raises(FileNotFoundError):
        loop.run_until_complete(async_execute_process(AsyncSubprocessProtocol, ['no_such_program_here']))
    loop.close()


def test_program_can_be_signalled() -> None:
    async def run() -> int:
        transport, protocol = await async_execute_process(AsyncSubprocessProtocol, 'exec sleep 20', shell=True)
        transport.terminate()
        code: int = await protocol.complete
        return code

    loop = get_loop()
    assert loop.run_until_complete(run()) == -15
    loop.close()


def test_lines_come_one_by_one_and_the_code_at_the_end() -> None:
    assert list(execute_process(['sh', '-c', 'echo a; printf b; exit 2'])) == [b'a\n', b'b', 2]
    assert list(execute_process_split('echo e >&2', shell=True)) == [(None, b'e\n', None), (None, None, 0)]
