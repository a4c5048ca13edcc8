"""launch_pytest.fixture: what it shares, takes and gives."""

from __future__ import annotations

from .conftest import Run
from .sources import ALIVE, SHARED


def test_fixtures_and_nodes_live_on_one_machine(inner: Run) -> None:
    done = inner("""
import rclpy
from std_msgs.msg import String
@pytest.fixture
def node():
    rclpy.init()
    yield rclpy.create_node('listener')
    rclpy.shutdown()
@launch_pytest.fixture
def talker():
    return launch.LaunchDescription([Node(package='demo_nodes_py', executable='talker')])
@pytest.mark.launch(fixture=talker)
def test_hears(node):
    heard = []
    node.create_subscription(String, 'chatter', lambda message: heard.append(message.data), 10)
    while len(heard) < 2:
        rclpy.spin_once(node, timeout_sec=5)
    assert heard == ['Hello World: 0', 'Hello World: 1']
""")
    assert done.outcomes == [('test_hears', 'passed')], done.text


def test_launch_fixtures_may_be_parametrized_and_yield(inner: Run) -> None:
    done = inner("""
ended = []
@launch_pytest.fixture(params=['a', 'b'], name='told')
def tell(request, launch_service):
    yield launch.LaunchDescription([KeepAliveProc()]), request.param
    ended.append(launch_service.event_loop is None)
@pytest.mark.launch(fixture=tell)
@pytest.mark.parametrize('number', [1, 2])
def test_values(told, number):
    assert told[1] in 'ab'
def test_ended():
    assert ended == [True] * 4
""")
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 5, done.text


def test_fixtures_of_one_scope_share_a_launch(inner: Run) -> None:
    done = inner(
        SHARED
        + """
@launch_pytest.fixture(scope='module')
def more(proc):
    return launch.LaunchDescription([KeepAliveProc()])
@pytest.mark.launch(fixture=shared)
def test_one(launch_service):
    assert launch_service.event_loop is not None
@pytest.mark.launch(fixture=more)
def test_other(proc):
    assert proc.return_code is None
"""
    )
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 2, done.text


def test_a_launch_may_be_left_to_end_by_itself(inner: Run) -> None:
    done = inner("""
@launch_pytest.fixture(auto_shutdown=False)
def short():
    return launch.LaunchDescription([TimerAction(period=7.0, actions=[])])
@pytest.mark.launch(fixture=short)
async def test_it(event_loop):
    global began
    began = event_loop.time()
    yield
    assert event_loop.time() - began == pytest.approx(7.0)
""")
    assert done.outcomes == [('test_it', 'passed')], done.text


def test_a_conftest_may_hold_the_fixtures(inner: Run) -> None:
    done = inner(
        ALIVE
        + """
@pytest.mark.launch(fixture=alive)
def test_it(from_conftest):
    assert from_conftest == 'launch_pytest'
""",
        conftest='import launch_pytest, pytest\n@pytest.fixture\ndef from_conftest(): return launch_pytest.__name__\n',
    )
    assert done.outcomes == [('test_it', 'passed')], done.text


def test_a_wider_scope_lives_longer_and_an_unknown_one_shortest() -> None:
    from launch_pytest.fixture import SCOPES, _lifetime

    assert [_lifetime(scope) for scope in ('function', 'session')] == [SCOPES.index('function'), SCOPES.index('session')]
    assert _lifetime('session') > _lifetime('function') > _lifetime(lambda: 'module')
