"""A small recording made by hand through the graph: no launch, no rclpy."""

from __future__ import annotations

from typing import Any

import pytest

import edulaunch
from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import Origin, ProcessSpec
from edulaunch.engine.recording import Recorder, Recording
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.runtime.fittings import hint_of


class Stage:
    """A simulation with a recorder, and short ways to make things happen at a time."""

    def __init__(self) -> None:
        edulaunch.source()
        from edulaunch.engine.processes.host import Host

        self.sim = Simulation(seed=7)
        self.recorder = Recorder(self.sim)
        self.graph = Graph(self.sim, self.recorder)
        self.host = Host(self.sim, self.graph, None, env={}, hint_of=hint_of)  # type: ignore[arg-type]

    def process(self, name: str, seconds: float) -> Process:
        spec = ProcessSpec(
            argv=('/opt/lib/p/' + name,),
            name=name,
            origin=Origin('/home/me/a.launch.py', 12),
            package='p',
            executable=name,
            parameter_origins={'radius': 'launch argument circle_radius'},
        )
        from edulaunch.engine.sim import sync

        return self.host.adopt(Process(self.host, spec, self.host.next_pid(), [name], lambda _: sync.sleep(seconds)))

    def at(self, seconds: float, action: Any) -> None:
        self.sim.schedule(self.sim.start_ns + round(seconds * 1e9), action)

    def finish(self, seconds: float) -> Recording:
        self.sim.run(self.sim.start_ns + round(seconds * 1e9))
        recording = self.recorder.recording()
        self.host.close()
        return recording


def turtle_run() -> Recording:
    """turtle1 drives along x for two seconds; a node called 'watcher' listens and leaves early."""
    stage = Stage()
    from geometry_msgs.msg import TransformStamped
    from tf2_msgs.msg import TFMessage
    from turtlesim.msg import Pose
    from turtlesim.srv import Spawn

    sim, graph = stage.sim, stage.graph
    process, watcher = stage.process('sim-1', 100), stage.process('watcher-2', 1.5)
    node, other = graph.add_node(process, 'sim', '/'), graph.add_node(watcher, 'watcher', '/ns')
    publisher = graph.create_publisher(node, '/turtle1/pose', Pose, QoS())
    tf = graph.create_publisher(node, '/tf', TFMessage, QoS())
    graph.create_subscription(other, '/turtle1/pose', Pose, QoS(), lambda: None)
    server = graph.create_service(node, '/spawn', Spawn, QoS(), lambda: server.respond(server.take()[1], ('turtle2',)))
    client = graph.create_client(other, '/spawn', Spawn, QoS(), lambda: None)
    stage.recorder.parameter(node, 'background_r', 69, 'default')
    stage.recorder.parameter(node, 'background_r', 150, 'command line')
    for step in range(5):

        def tick(step: int = step) -> None:
            publisher.publish(Pose.to_wire(Pose(x=1.0 + step, y=2.0, theta=0.0)))
            message = TransformStamped(child_frame_id='turtle1')
            message.header.frame_id = 'world'
            message.header.stamp.sec, message.header.stamp.nanosec = divmod(sim.now_ns, 10**9)
            message.transform.translation.x = 1.0 + step
            tf.publish(TFMessage.to_wire(TFMessage(transforms=[message])))

        stage.at(step * 0.5, tick)
    stage.at(0.25, lambda: client.send(Spawn.Request.to_wire(Spawn.Request(x=4.0, y=2.0, name='turtle2'))))
    stage.at(1.0, lambda: process.log(20, 'sim', 'Spawning turtle [turtle2]'))
    stage.at(1.0, lambda: process.write('stderr', 'half a line'))
    return stage.finish(2.5)


@pytest.fixture(scope='module')
def recording() -> Recording:
    return turtle_run()


@pytest.fixture
def stage() -> Stage:
    return Stage()
