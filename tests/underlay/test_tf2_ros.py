"""tf2_ros in running nodes: broadcasters, listener, buffer, waiting, registration."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import rclpy
import tf2_ros
from geometry_msgs.msg import PointStamped, TransformStamped
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_msgs.srv import FrameGraph

from edulaunch.facts import facts_of
from edulaunch.graph.qos import TRANSIENT_LOCAL, QoS


def stamped(parent: str, child: str, seconds: float, x: float) -> TransformStamped:
    ns = round(seconds * 1e9)
    return TransformStamped.from_wire((*divmod(ns, 10**9), parent, child, x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))


@pytest.fixture
def program(stage: Any) -> Callable[[Callable[[], object]], Any]:
    """Runs a function as a program of its own at the start of the simulation."""

    def start(body: Callable[[], object]) -> Any:
        from edulaunch.processes.process import Process
        from edulaunch.processes.spec import ProcessSpec

        process = Process(stage.host, ProcessSpec(argv=('program',), name='program'), 4242, ['program'], lambda _: body())
        process.task.start()
        return process

    return start


def listening(stage: Any, program: Any, use: Callable[[Node, tf2_ros.Buffer], None], **options: Any) -> None:
    """A program with a node, a buffer and a listener, set up by `use` and then spun."""

    def body() -> None:
        rclpy.init()
        node = Node('listener')
        buffer = tf2_ros.Buffer(**options)
        node.keep = tf2_ros.TransformListener(buffer, node)
        use(node, buffer)
        rclpy.spin(node)

    program(body)


def test_what_one_program_broadcasts_another_one_looks_up(stage, program):
    seen: list[tuple[float, float]] = []

    def broadcaster() -> None:
        rclpy.init()
        node = Node('broadcaster')
        sender = tf2_ros.TransformBroadcaster(node)

        def send() -> None:
            now = node.get_clock().now().nanoseconds * 1e-9
            sender.sendTransform(stamped('world', 'turtle1', now, stage.tape.now_ms()))

        node.create_timer(0.1, send)
        rclpy.spin(node)

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        def look() -> None:
            found = buffer.lookup_transform('world', 'turtle1', Time())
            seen.append((stage.tape.now_ms(), found.transform.translation.x))

        node.create_timer(0.27, look)

    program(broadcaster)
    listening(stage, program, use)
    stage.until(800)
    assert seen == [(270.0, 200.0), (540.0, 500.0)]


def test_a_dropped_listener_hears_nothing(stage, program):
    names: list[str] = []

    def body() -> None:
        rclpy.init()
        node, buffer = Node('forgetful'), tf2_ros.Buffer()
        tf2_ros.TransformListener(buffer, node)
        node.create_timer(0.5, lambda: names.append(buffer.all_frames_as_yaml()))
        rclpy.spin(node)

    program(body)
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'turtle1', 1.0, 1.0)]))
    stage.until(600)
    assert names == ['[]']


def test_a_static_broadcaster_repeats_all_frames_but_never_changes_one(stage, program):
    def body() -> None:
        rclpy.init()
        sender = tf2_ros.StaticTransformBroadcaster(Node('static'))
        sender.sendTransform(stamped('world', 'a', 1.0, 1.0))
        sender.sendTransform([stamped('world', 'a', 1.0, 9.0), stamped('world', 'b', 1.0, 2.0)])

    program(body)
    stage.until(10)
    sent = [
        [(one.child_frame_id, one.transform.translation.x) for one in message.transforms]
        for message in stage.messages('/tf_static')
    ]
    assert sent == [[('a', 1.0)], [('a', 1.0), ('b', 2.0)]]


def test_a_late_listener_gets_static_frames(stage, program):
    found: list[float] = []
    hand = stage.graph.add_node(None, 'early', '/')
    publisher = stage.graph.create_publisher(hand, '/tf_static', TFMessage, QoS(depth=1, durability=TRANSIENT_LOCAL))
    publisher.publish(TFMessage.to_wire(TFMessage(transforms=[stamped('world', 'lamp', 0.0, 3.0)])))
    stage.until(1000)
    listening(
        stage,
        program,
        lambda node, buffer: node.create_timer(
            0.1, lambda: found.append(buffer.lookup_transform('world', 'lamp', Time(seconds=5)).transform.translation.x)
        ),
    )
    stage.until(1150)
    assert found == [3.0]


def test_a_lookup_with_a_timeout_blocks_its_executor_to_the_end(stage, program):
    log: list[tuple[float, str]] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        def look() -> None:
            try:
                buffer.lookup_transform('world', 'late', Time(), timeout=Duration(seconds=1.0))
            except tf2_ros.TransformException as error:
                log.append((stage.tape.now_ms(), f'{type(error).__name__}: {error}'))

        node.create_timer(2.0, look)

    listening(stage, program, use)
    stage.until(2100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 1.0)]))
    stage.until(3500)
    assert log == [(3000.0, 'LookupException: "world" passed to lookupTransform argument target_frame does not exist. ')]


@pytest.mark.parametrize('timeout', [1.0, 1, Duration(seconds=1.0).to_msg()])
def test_a_timeout_is_an_rclpy_duration(timeout):
    with pytest.raises(TypeError, match=r"unsupported operand type\(s\) for \+: 'Time' and '(float|int|Duration)'") as caught:
        tf2_ros.Buffer().lookup_transform('world', 'a', Time(), timeout=timeout)
    assert facts_of(caught.value)['about'] == 'programs.timeout-no-duration'


def test_with_threads_to_spare_a_lookup_in_a_callback_gets_its_data(stage, program):
    log: list[tuple[float, float]] = []

    def body() -> None:
        rclpy.init()
        node, buffer = Node('patient'), tf2_ros.Buffer()
        node.keep = tf2_ros.TransformListener(buffer, node)

        def look() -> None:
            timer.cancel()
            found = buffer.lookup_transform('world', 'late', Time(), timeout=Duration(seconds=1.0))
            log.append((stage.tape.now_ms(), found.transform.translation.x))

        timer = node.create_timer(0.1, look)
        executor = rclpy.executors.MultiThreadedExecutor(num_threads=2)
        executor.add_node(node)
        executor.spin()

    program(body)
    stage.until(301)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 7.0)]))
    stage.until(2000)
    assert log == [(320.0, 7.0)]


def test_a_listener_may_have_callbacks_of_its_own(stage, program):
    heard: list[str] = []

    class Curious(tf2_ros.TransformListener):
        def callback(self, data: TFMessage) -> None:
            heard.append('moving')
            super().callback(data)

        def static_callback(self, data: TFMessage) -> None:
            heard.append('static')
            super().static_callback(data)

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        node.keep = Curious(buffer, node)
        node.create_timer(0.15, lambda: heard.append(buffer.all_frames_as_string()))

    listening(stage, program, use)
    hand = stage.graph.add_node(None, 'early', '/')
    latched = stage.graph.create_publisher(hand, '/tf_static', TFMessage, QoS(durability=TRANSIENT_LOCAL))
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'a', 1.0, 1.0)]))
    latched.publish(TFMessage.to_wire(TFMessage(transforms=[stamped('world', 'b', 0.0, 1.0)])))
    stage.until(200)
    assert heard == ['moving', 'static', 'Frame a exists with parent world.\nFrame b exists with parent world.\n']


def test_with_a_thread_of_its_own_the_wait_ends_when_the_data_comes(stage, program):
    log: list[tuple[float, float]] = []

    def body() -> None:
        rclpy.init()
        node, buffer = Node('threaded'), tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer, node, spin_thread=True)
        found = buffer.lookup_transform('world', 'late', Time(), timeout=Duration(seconds=1.0))
        log.append((stage.tape.now_ms(), found.transform.translation.x))
        listener.unregister()

    program(body)
    stage.until(101)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 7.0)]))
    stage.until(2000)
    assert log == [(120.0, 7.0)]


def test_a_future_is_done_when_the_transform_arrives(stage, program):
    log: list[tuple[float, float]] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        future = buffer.wait_for_transform_async('world', 'late', Time())
        future.add_done_callback(lambda done: log.append((stage.tape.now_ms(), done.result().transform.translation.x)))

    listening(stage, program, use)
    stage.until(300)
    for x in (4.0, 5.0):
        stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', x, x)]))
    stage.until(400)
    assert log == [(300.0, 4.0)]


def test_a_coroutine_callback_can_await_a_transform(stage, program):
    log: list[tuple[float, float]] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        async def look() -> None:
            timer.cancel()
            found = await buffer.lookup_transform_async('world', 'late', Time())
            log.append((stage.tape.now_ms(), found.transform.translation.x))

        timer = node.create_timer(0.1, look)

    listening(stage, program, use)
    stage.until(350)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 6.0)]))
    stage.until(1000)
    assert log == [(350.0, 6.0)]


def test_a_buffer_with_a_node_offers_its_frames(stage, program):
    def body() -> None:
        rclpy.init()
        node = Node('owner', namespace='robot')
        buffer = tf2_ros.Buffer(node=node)
        buffer.set_transform(stamped('world', 'a', 1.0, 1.0), 'me')
        rclpy.spin(node)

    program(body)
    stage.until(10)
    replies = stage.ask('/robot/tf2_frames', FrameGraph)
    stage.until(20)
    assert replies[0].frame_yaml.startswith("a: \n  parent: 'world'\n  broadcaster: 'me'\n")


def test_a_refused_transform_is_logged_by_the_unnamed_logger(stage, program):
    listening(stage, program, lambda node, buffer: None)
    stage.until(10)
    stage.publish('/tf', TFMessage(transforms=[stamped('a', 'a', 1.0, 1.0)]))
    stage.until(20)
    text = (
        'TF_SELF_TRANSFORM: Ignoring transform from authority "default_authority" with frame_id and  '
        'child_frame_id "a" because they are the same'
    )
    assert stage.tape.logs == [(10.0, text)]
    assert stage.tape.outputs == [(10.0, f'[ERROR] [1700000000.010000000] []: {text}\n')]


def test_objects_are_transformed_by_the_function_of_their_type(stage, program):
    results: list[Any] = []

    class Thing:
        header = PointStamped().header

    def body() -> None:
        rclpy.init()
        buffer = tf2_ros.Buffer()
        buffer.set_transform_static(stamped('world', '', 0.0, 1.0), 'me')
        buffer.set_transform_static(stamped('world', 'a', 0.0, 5.0), 'me')
        thing = Thing()
        thing.header.frame_id = 'a'
        try:
            buffer.transform(thing, 'world')
        except tf2_ros.TypeException as error:
            results.append(str(error))
        tf2_ros.TransformRegistration().add(Thing, lambda one, found: found.transform.translation.x)
        results.append(buffer.transform(thing, 'world'))

    program(body)
    stage.until(10)
    assert results == [f'Type {Thing} is not loaded or supported', 5.0]


def test_points_are_transformed_once_tf2_geometry_msgs_is_imported(stage, program):
    results: list[Any] = []

    def body() -> None:
        import tf2_geometry_msgs  # noqa: F401  registers its types

        rclpy.init()
        buffer = tf2_ros.Buffer()
        for seconds in (1, 2):
            buffer.set_transform(stamped('world', 'a', seconds, 5.0 * seconds), 'me')
        point = PointStamped()
        point.header.frame_id, point.point.x = 'a', 1.0
        results.append(buffer.transform(point, 'world').point.x)
        point.header.stamp.sec = 1
        results.append(buffer.transform_full(point, 'a', Time(seconds=2), 'world').point.x)
        results.append(buffer.transform(point, 'world', new_type=PointStamped).header.frame_id)

    program(body)
    stage.until(10)
    assert results == [11.0, -4.0, 'world']


def test_convert_goes_directly_or_over_a_message(stage, program):
    results: list[Any] = []

    def body() -> None:
        registration = tf2_ros.ConvertRegistration()
        registration.add_to_msg(complex, lambda value: (value.real, value.imag))
        registration.add_from_msg(str, lambda pair: f'{pair[0]} {pair[1]}')
        registration.add_convert((complex, float), abs)
        results.extend([tf2_ros.convert(3 + 4j, str), tf2_ros.convert(3 + 4j, float), tf2_ros.convert('x', str)])
        with pytest.raises(tf2_ros.TypeException, match="Type <class 'int'> is not loaded or supported"):
            tf2_ros.convert(3 + 4j, int)

    program(body)
    stage.until(10)
    assert results == ['3.0 4.0', 5.0, 'x']


def test_all_names_of_the_package_can_be_imported():
    assert {name: getattr(tf2_ros, name).__name__ for name in tf2_ros.__all__} == {n: n for n in tf2_ros.__all__}
    assert tf2_ros.buffer.Buffer is tf2_ros.Buffer
    with pytest.raises(ImportError):
        from tf2_ros import Bufer  # noqa: F401


class CountingBuffer(tf2_ros.Buffer):
    """A student's buffer that looks at every transform."""

    def __init__(self, seen: list[Any]) -> None:
        super().__init__()
        self._seen = seen

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """See Buffer.set_transform."""
        self._seen.append((type(transform), transform.child_frame_id, authority))
        super().set_transform(transform, authority)


def test_a_buffer_with_a_set_transform_of_its_own_gets_messages(stage, program):
    seen: list[Any] = []

    def body() -> None:
        rclpy.init()
        node = Node('listener')
        node.keep = tf2_ros.TransformListener(CountingBuffer(seen), node)
        rclpy.spin(node)

    program(body)
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'a', 1.0, 1.0), stamped('world', 'b', 1.0, 1.0)]))
    stage.until(200)
    assert seen == [(TransformStamped, 'a', 'default_authority'), (TransformStamped, 'b', 'default_authority')]


def test_another_callback_takes_the_place_of_the_listeners(stage, program):
    heard: list[str] = []
    frames: list[str] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        node.keep.tf_sub.callback = lambda message: heard.append(message.transforms[0].child_frame_id)
        node.create_timer(0.15, lambda: frames.append(buffer.all_frames_as_yaml()))

    listening(stage, program, use)
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'a', 1.0, 1.0)]))
    stage.until(200)
    assert (heard, frames) == (['a'], ['[]'])


def test_refused_transforms_are_logged_whichever_way_they_come(stage, program):
    listening(stage, program, lambda node, buffer: None)
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('a', 'a', 1.0, 1.0)]))
    stage.until(200)
    assert [text for _, text in stage.tape.logs if 'TF_SELF_TRANSFORM' in text]


def test_a_listener_feeds_the_buffer_that_it_has_now(stage: Any, program: Any) -> None:
    seen = []

    def body() -> None:
        rclpy.init()
        node = Node('n')
        first, second = tf2_ros.Buffer(), tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(first, node)
        publisher = node.create_publisher(TFMessage, '/tf', 10)
        for child in 'abc':
            publisher.publish(TFMessage(transforms=[stamped('world', child, 1.0, 0.0)]))
            rclpy.spin_once(node, timeout_sec=0.1)
            listener.buffer = second
        seen.extend(buffer.all_frames_as_yaml().count('parent') for buffer in (first, second))

    program(body)
    stage.until(1000)
    assert seen == [1, 2]
