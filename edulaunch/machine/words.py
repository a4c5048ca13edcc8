"""What can be said to a machine itself: `edulaunch machine status|stop|pause|resume|speed X`, `edulaunch network ...`."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.machine.terminals import Terminals

FASTEST, SLOWEST = 100.0, 0.01


def run_words(terminals: Terminals, words: list[str], env: Mapping[str, str], say: Callable[[str], object]) -> int:
    """Do what the words say; returns the exit code."""
    word, value = (words + ['status', ''])[:2] if words else ('status', '')
    if word == 'network':
        from edulaunch.network.switch import run_network

        return run_network(terminals.switch(), words[1:], env, say, terminals.tell)
    if terminals.time.is_wall and word in ('pause', 'resume', 'speed'):
        say('the network is on: time goes with the clock on the wall\n  help: edulaunch network off\n')
        return 1
    if word == 'status':
        say(status(terminals))
    elif word == 'stop':
        terminals.is_asked_to_end = True
        say('the machine stops\n')
    elif word in ('pause', 'resume'):
        terminals.time.paused = word == 'pause'
        say(f'time {"stands still" if terminals.time.paused else "goes on"} at {terminals.session.sim.elapsed_s:.3f} s\n')
    elif word == 'speed':
        return _set_speed(terminals, value, say)
    else:
        say(f'unknown word {word!r}: status, stop, pause, resume or speed X\n')
        return 2
    return 0


def _set_speed(terminals: Terminals, value: str, say: Callable[[str], object]) -> int:
    try:
        speed = float(value)
    except ValueError:
        speed = 0.0
    if not SLOWEST <= speed <= FASTEST:
        say(f'{value!r} is not a speed from {SLOWEST} to {FASTEST:.0f} simulated seconds per second\n')
        return 2
    terminals.time.speed = speed
    say(f'one second is {speed:g} simulated seconds now\n')
    return 0


def status(terminals: Terminals) -> str:
    """What runs on the machine, in words."""
    time, session = terminals.time, terminals.session
    pace = 'paused' if time.paused else f'speed {time.speed:g}'
    lines = [f'machine: process {os.getpid()}, {session.sim.elapsed_s:.1f} s old, {pace}']
    for terminal in terminals.open_ones:
        programs = len(terminal.programs())
        lines.append(f'terminal {terminal.number}: {" ".join(terminal.words)} ({programs} program{"s" * (programs != 1)})')
    return '\n'.join(lines) + '\n'
