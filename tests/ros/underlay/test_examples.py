"""The programs of examples_rclpy_* and action_tutorials_py: who says what, and when."""

from __future__ import annotations

from typing import Any

import pytest
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import String

from edulaunch.engine.packages import Index

PUBLISHER, SUBSCRIBER, SERVICE, CLIENT, SERVER, ACTION_CLIENT, EXECUTORS = (
    f'examples_rclpy_{name}'
    for name in (
        'minimal_publisher',
        'minimal_subscriber',
        'minimal_service',
        'minimal_client',
        'minimal_action_server',
        'minimal_action_client',
        'executors',
    )
)


def programs(package: str) -> list[str]:
    return Index().executables(package)


def test_the_packages_have_the_executables_of_ros() -> None:
    assert {name: len(programs(name)) for name in Index().packages() if name.startswith('examples_rclpy')} == {
        'examples_rclpy_executors': 6,
        'examples_rclpy_guard_conditions': 1,
        'examples_rclpy_minimal_action_client': 4,
        'examples_rclpy_minimal_action_server': 5,
        'examples_rclpy_minimal_client': 4,
        'examples_rclpy_minimal_publisher': 3,
        'examples_rclpy_minimal_service': 2,
        'examples_rclpy_minimal_subscriber': 3,
        'examples_rclpy_pointcloud_publisher': 1,
    }


@pytest.mark.parametrize('executable', programs(PUBLISHER))
def test_a_publisher_counts_twice_a_second(stage: Any, executable: str) -> None:
    stage.start(PUBLISHER, executable)
    stage.until(1300)
    first = 0.0 if executable == 'publisher_old_school' else 500.0
    assert stage.tape.logs[:2] == [(first, 'Publishing: "Hello World: 0"'), (first + 500.0, 'Publishing: "Hello World: 1"')]
    assert stage.messages('/topic')[0] == String(data='Hello World: 0')
    assert [node.name for node in stage.graph.nodes][1:] == ['minimal_publisher']


@pytest.mark.parametrize('executable', programs(SUBSCRIBER))
def test_a_subscriber_says_what_it_heard(stage: Any, executable: str) -> None:
    stage.start(SUBSCRIBER, executable)
    stage.until(100)
    stage.publish('/topic', String(data='hello'))
    stage.until(200)
    assert stage.tape.logs == [(100.0, 'I heard: "hello"')]


@pytest.mark.parametrize('client', programs(CLIENT))
@pytest.mark.parametrize('service', programs(SERVICE))
def test_a_client_waits_for_the_service_and_gets_its_sum(stage: Any, client: str, service: str) -> None:
    asking = stage.start(CLIENT, client)
    stage.until(1500)
    stage.start(SERVICE, service)
    stage.until(4000)
    assert stage.texts() == [
        'service not available, waiting again...',
        'Incoming request\na: 41 b: 1',
        'Result of add_two_ints: for 41 + 1 = 42',
    ]
    assert asking.returncode == 0


LAST = "array('i', [0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55])"


@pytest.mark.parametrize('server', programs(SERVER))
@pytest.mark.parametrize('client', [name for name in programs(ACTION_CLIENT) if name != 'client_cancel'])
def test_an_action_client_gets_its_numbers(stage: Any, server: str, client: str) -> None:
    if (server, client) == ('server_defer', 'client_asyncio'):
        pytest.skip('of two goals at once the original, too, only remembers the last')
    stage.start(SERVER, server)
    stage.until(100)
    asking = stage.start(ACTION_CLIENT, client)
    stage.until(30_000)
    texts = stage.texts()
    assert texts[0].startswith('Waiting for action server...') and 'Goal accepted :)' in texts
    assert f'Returning result: {LAST}' in texts and asking.returncode == 0
    told = [f'Result: {LAST}'] if client == 'client_asyncio' else [f'Goal succeeded! Result: {LAST}']
    assert set(told) <= set(texts)


@pytest.mark.parametrize('server', ['server', 'server_not_composable', 'server_queue_goals', 'server_single_goal'])
def test_a_goal_is_cancelled_after_two_seconds(stage: Any, server: str) -> None:
    stage.start(SERVER, server)
    asking = stage.start(ACTION_CLIENT, 'client_cancel')
    stage.until(5000)
    texts = stage.texts()
    assert 'Received cancel request' in texts and 'Goal canceled' in texts and 'Goal successfully canceled' in texts
    assert asking.returncode == 0


def test_the_servers_treat_a_second_goal_differently(stage: Any) -> None:
    seen = {}
    for name in ('server_queue_goals', 'server_single_goal'):
        server = stage.start(SERVER, name)
        clients = [stage.start(ACTION_CLIENT, 'client') for _ in range(2)]
        stage.until((stage.sim.now_ns - stage.sim.start_ns) / 1e6 + 30_000)
        server.send_signal(9)
        seen[name] = stage.texts()
        stage.tape.logs.clear()
        assert [client.returncode for client in clients] == [0, 0]
    assert (
        'Goal put in the queue' in seen['server_queue_goals']
        and 'Start executing next goal in queue' in seen['server_queue_goals']
    )
    assert seen['server_queue_goals'].count(f'Goal succeeded! Result: {LAST}') == 2
    assert 'Aborting previous goal' in seen['server_single_goal'] and 'Goal aborted' in seen['server_single_goal']
    assert 'Goal failed with status: 6' in seen['server_single_goal']


def test_a_deferred_goal_begins_three_seconds_later(stage: Any) -> None:
    stage.start(SERVER, 'server_defer')
    stage.start(ACTION_CLIENT, 'client')
    stage.until(4000)
    times = {text: at for at, text in stage.tape.logs}
    assert times['Executing goal...'] - times['Deferring execution...'] == pytest.approx(3000.0)


@pytest.mark.parametrize(
    ('executable', 'count'), [('composed', 3), ('callback_group', 9), ('custom_executor', 3), ('custom_callback_group', 0)]
)
def test_executors_spin_several_nodes(stage: Any, executable: str, count: int) -> None:
    stage.start(EXECUTORS, executable)
    stage.until(3100)
    texts = stage.texts()
    assert texts[0] == 'Publishing: "Hello World: 0"'
    assert [text.partition(':')[0] for text in texts].count('I heard') == count
    if executable == 'custom_callback_group':
        assert 10 < len(texts) < 30  # throttled: 30 would be all


def test_an_estop_is_heard(stage: Any) -> None:
    stage.start(EXECUTORS, 'custom_executor')
    stage.until(50)
    stage.publish('/estop', String(data='halt'))
    stage.until(100)
    assert stage.tape.logs == [(50.0, 'I heard: halt')]


def test_a_guard_condition_calls_its_callback_and_the_program_ends(stage: Any) -> None:
    process = stage.start('examples_rclpy_guard_conditions', 'trigger_guard_condition')
    stage.until(100)
    assert stage.texts() == ['guard callback called'] and process.returncode == 0


def test_the_wave_is_a_cloud_of_ten_thousand_points(stage: Any) -> None:
    stage.start('examples_rclpy_pointcloud_publisher', 'pointcloud_publisher')
    stage.until(200)
    clouds = stage.messages('/test_cloud')
    assert len(clouds) == 6 and isinstance(clouds[0], PointCloud2)
    assert (clouds[0].header.frame_id, clouds[0].width * clouds[0].height, len(clouds[0].data)) == ('map', 10_000, 160_000)
    assert clouds[0].data != clouds[1].data


def test_the_action_tutorial(stage: Any) -> None:
    client = stage.start('action_tutorials_py', 'fibonacci_action_client')
    stage.until(500)
    stage.start('action_tutorials_py', 'fibonacci_action_server')
    stage.until(20_000)
    texts = stage.texts()
    assert {'Goal accepted :)', 'Executing goal...'} <= set(texts[:3])
    assert "Feedback: array('i', [0, 1, 1])" in texts and "Received feedback: array('i', [0, 1, 1])" in texts
    assert texts[-1] == f'Result: {LAST}' and client.returncode == 0
