"""`ros2 doctor`, `daemon` and `multicast` in the simulation."""

from __future__ import annotations

import pytest

PUBLISHERS = [
    'UserWarning: Subscriber without publisher detected on /turtle1/cmd_vel.',
    'UserWarning: Publisher without subscriber detected on /turtle1/color_sensor.',
    'UserWarning: Publisher without subscriber detected on /turtle1/pose.',
]


@pytest.mark.parametrize('name', ['doctor', 'wtf'])
def test_all_checks_pass_with_warnings_about_lonely_topics(machine, name: str) -> None:
    typed = machine.run(f'ros2 {name}')
    assert (typed.code, typed.out) == (0, '\nAll 5 checks passed\n\n')
    assert [line.partition(': ')[2].partition(': ')[2] for line in typed.err.splitlines()] == PUBLISHERS


def test_warnings_count_as_failures_on_request(machine) -> None:
    typed = machine.run('ros2 doctor -iw -ep -rf')
    assert typed.code == 1
    assert typed.out.startswith('\n1/4 check(s) failed\n\nFailed modules: topic\n\n\n   TOPIC LIST\n')


def test_ends_that_do_not_fit_fail_a_check(machine) -> None:
    machine.run('ros2 topic echo /turtle1/pose --qos-durability transient_local')
    typed = machine.run('ros2 doctor')
    assert (typed.code, typed.out) == (1, '\n1/5 check(s) failed\n\nFailed modules: qos\n\n')
    assert '/turtle1/pose: ' in typed.err


def test_the_report_has_the_sections_of_ros(machine) -> None:
    lines = machine.read('ros2 doctor --report').splitlines()
    assert [line.strip() for line in lines if line.startswith('   ')] == [
        'NETWORK CONFIGURATION',
        'PACKAGE VERSIONS',
        'PLATFORM INFORMATION',
        'QOS COMPATIBILITY LIST',
        'RMW MIDDLEWARE',
        'ROS 2 INFORMATION',
        'TOPIC LIST',
    ]
    assert 'distribution name      : jazzy' in lines
    assert 'topic               : /turtle1/pose' in lines


@pytest.mark.parametrize('verb', ['start', 'status', 'stop'])
def test_no_daemon_is_needed(machine, verb: str) -> None:
    assert 'none is needed here' in machine.read(f'ros2 daemon {verb}')


def test_a_datagram_reaches_whoever_waits(machine) -> None:
    waiting = machine.run('ros2 multicast receive')
    assert machine.read('ros2 multicast send') == 'Sending one UDP multicast datagram...\n'
    assert waiting.code == 0
    assert waiting.out == "Waiting for UDP multicast datagram...\nReceived from 127.0.0.1:49150: 'Hello World!'\n"
    assert machine.run('ros2 multicast receive --timeout 1', 2.0).code == 1


def test_commands_that_are_not_here_say_why(machine) -> None:
    typed = machine.run('ros2 security create_keystore x')
    assert typed.code == 2
    assert typed.err.endswith('  help: a simulated machine has no network to protect\n')
