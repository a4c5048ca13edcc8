"""The buffer that nodes use. It can wait for transforms, and records failed lookups as facts."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy.duration import Duration
from tf2_py import BufferCore
from tf2_py.buffer_core import NS_PER_S, exception_of, message, nanoseconds, report

from edulaunch.engine.facts import kind_of, with_facts
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.frame_owner import student_line
from edulaunch.engine.sim.sync import sleep
from edulaunch.engine.sim.task import current_task
from edulaunch.engine.tf import TransformFailure
from edulaunch.ros.passed_on import passed_on
from tf2_ros.buffer_interface import NO_WAIT, BufferInterface

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped
    from rclpy.node import Node
    from rclpy.task import Future

    from edulaunch.engine.tf import TransformBuffer

KIND = 'lookup failed'
MOST_FRAMES = 40


class FailedLookups:
    """The failed lookups of one buffer, by target and source frame.

    :param number: the number of the buffer in its program.
    """

    def __init__(self, number: int) -> None:
        self._number = number
        self.pairs: set[tuple[str, str]] = set()

    def note(
        self, buffer: TransformBuffer, target: str, source: str, time_ns: int, kind: str, text: str, waited_s: float = 0.0
    ) -> None:
        """Record a failed lookup.

        :param kind: the kind of failure.
        :param text: tf2's message.
        :param waited_s: the timeout of the lookup, in seconds.
        """
        process = current_process()
        self.pairs.add((target, source))
        names = buffer.frame_names()
        data = {
            'target': target,
            'source': source,
            'why': kind,
            'text': text,
            'asked_s': (time_ns - process.sim.start_ns) / 1e9 if time_ns else None,
            'unknown': [name for name in dict.fromkeys((target, source)) if not buffer.frame_exists(name)],
            'frames': names[:MOST_FRAMES],
            'waited_s': waited_s,
        }
        process.fact(KIND, (self._number, target, source), {**data, **student_line()})

    def found(self, target: str, source: str) -> None:
        """Remove a failed lookup, because the same lookup has now succeeded."""
        if (target, source) in self.pairs:
            self.pairs.remove((target, source))
            current_process().fact_over(KIND, (self._number, target, source))


def of_next_buffer() -> FailedLookups:
    """Return an empty record of failed lookups for a new buffer in the running program."""
    state = current_process().state
    state['tf2_ros.buffers'] = number = state.get('tf2_ros.buffers', 0) + 1
    return FailedLookups(number)


POLL_S = 0.02


class Buffer(BufferCore, BufferInterface):
    """Stores transforms and looks them up, with an optional timeout. It mirrors `tf2_ros.buffer.Buffer` of Jazzy.

    :param cache_time: how long the samples of each frame are stored (a Duration); None means 10 s.
    :param node: a node that offers the service `tf2_frames`, and whose clock reports jumps back in time; None means no node.
    """

    def __init__(self, cache_time: Duration | None = None, node: Node | None = None) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self.new_data_callbacks: list[Callable[[], None]] = []
        self._failed = of_next_buffer()
        from rclpy.clock import Clock, JumpThreshold

        if node is not None:
            from tf2_msgs.srv import FrameGraph

            self.srv = node.create_service(FrameGraph, 'tf2_frames', self._answer_frames)
        self.clock = Clock() if node is None else node.get_clock()
        threshold = JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=True)
        self.jump_handle = self.clock.create_jump_callback(threshold, post_callback=self.time_jump_callback)

    def _answer_frames(self, request: Any, response: Any) -> Any:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def time_jump_callback(self, time_jump: Any) -> None:
        """Empty the buffer, because its stamps are no longer valid after a jump of the clock."""
        from rclpy.logging import get_logger

        get_logger('tf2_buffer').warning('Detected jump back in time. Clearing tf buffer.')
        self.clear()

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Add a transform, and repeat the waiting lookups."""
        BufferCore.set_transform(self, transform, authority)
        if self.new_data_callbacks:
            self._call_new_data_callbacks()

    def _set_wire(self, wire: tuple[Any, ...], authority: str) -> None:
        """Add the wire tuple of a transform; otherwise see :meth:`set_transform`."""
        rejections = self._tf.set(wire[2], wire[3], wire[0] * NS_PER_S + wire[1], wire[4:], authority)
        if rejections:
            report(rejections)
        if self.new_data_callbacks:
            self._call_new_data_callbacks()

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Add a static transform, and repeat the waiting lookups."""
        BufferCore.set_transform_static(self, transform, authority)
        if self.new_data_callbacks:
            self._call_new_data_callbacks()

    def _call_new_data_callbacks(self) -> None:
        for callback in list(self.new_data_callbacks):
            callback()

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT) -> TransformStamped:
        """Return the transform that maps coordinates in the source frame to the target frame.

        :param time: a time with `nanoseconds`, or with `sec` and `nanosec`; 0 means the latest time at which all frames have
            data.
        :param timeout: how long to wait for the transform. As in ROS 2, the node's executor is blocked meanwhile.
        :raises tf2.TransformException: one of LookupException, ConnectivityException, ExtrapolationException and
            InvalidArgumentException.
        """
        if timeout is not NO_WAIT:
            self.can_transform(target_frame, source_frame, time, timeout)
        try:  # a copy of lookup_transform_core without the call, because nodes that follow something need it very often
            stamp_ns, pose = self._tf.lookup(target_frame, source_frame, nanoseconds(time))
        except TransformFailure as failure:
            waited_s = timeout.nanoseconds / 1e9
            self._failed.note(self._tf, target_frame, source_frame, nanoseconds(time), failure.kind, str(failure), waited_s)
            raise exception_of(failure) from None
        if self._failed.pairs:
            self._failed.found(target_frame, source_frame)
        return message(target_frame, source_frame, stamp_ns, pose)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> TransformStamped:
        """Return the transform from the source frame at one time to the target frame at another time, through a fixed frame."""
        if timeout is not NO_WAIT:
            self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def can_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT, return_debug_tuple: bool = False
    ) -> Any:
        """Return 1 if the transform is available, and otherwise 0. With `return_debug_tuple`, return (1 or 0, the reason for
        0).
        """
        answer = self._wait_for(lambda: self.can_transform_core(target_frame, source_frame, time), timeout)
        if not answer[0]:
            waited_s = timeout.nanoseconds / 1e9
            self._failed.note(self._tf, target_frame, source_frame, nanoseconds(time), 'asked', answer[1], waited_s)
        elif self._failed.pairs:
            self._failed.found(target_frame, source_frame)
        return answer if return_debug_tuple else answer[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Return whether :meth:`lookup_transform_full` succeeds, in the form of :meth:`can_transform`."""
        answer = self._wait_for(
            lambda: self.can_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame), timeout
        )
        return answer if return_debug_tuple else answer[0]

    def _wait_for(self, check: Callable[[], tuple[int, str]], timeout: object) -> tuple[int, str]:
        """Check every 20 ms of simulated time until the condition is true or the timeout has passed.

        :raises TypeError: when the timeout is not an rclpy Duration, which ROS 2 reports when it adds the timeout to the time.
        """
        if not isinstance(timeout, Duration):
            error = TypeError(f"unsupported operand type(s) for +: 'Time' and '{type(timeout).__name__}'")
            raise with_facts(error, 'programs.timeout-no-duration', given=kind_of(timeout))
        timeout_ns = timeout.nanoseconds
        answer = check()
        if timeout_ns > 0 and not answer[0]:
            sim = current_task().sim
            deadline_ns = sim.now_ns + timeout_ns
            while not answer[0] and sim.now_ns < deadline_ns:
                sleep(POLL_S)
                answer = check()
        return answer

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Any) -> Future:
        """Return a future that is done as soon as the transform is available. The result of the future is the transform. There
        is no timeout.
        """
        future = self._future(
            lambda: self.can_transform_core(target_frame, source_frame, time),
            lambda: self.lookup_transform_core(target_frame, source_frame, time),
        )
        if not future.done():
            text = self.can_transform_core(target_frame, source_frame, time)[1]
            self._failed.note(self._tf, target_frame, source_frame, nanoseconds(time), 'asked', text)
            future.add_done_callback(lambda _: self._failed.found(target_frame, source_frame))
        return future

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Future:
        """Return a future for the transform of :meth:`lookup_transform_full`; see :meth:`wait_for_transform_async`."""
        times = (target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._future(lambda: self.can_transform_full_core(*times), lambda: self.lookup_transform_full_core(*times))

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Any) -> TransformStamped:
        """Await the transform in a coroutine; see :meth:`lookup_transform`."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> TransformStamped:
        """Await the transform in a coroutine; see :meth:`lookup_transform_full`."""
        await self.wait_for_transform_full_async(target_frame, target_time, source_frame, source_time, fixed_frame)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def _future(self, check: Callable[[], tuple[int, str]], lookup: Callable[[], TransformStamped]) -> Future:
        from rclpy.task import Future

        future = Future()
        if check()[0]:
            future.set_result(lookup())
            return future

        def on_new_data() -> None:
            if check()[0] and not future.done():
                future.set_result(lookup())

        def forget(_: object) -> None:
            if on_new_data in self.new_data_callbacks:
                self.new_data_callbacks.remove(on_new_data)

        self.new_data_callbacks.append(on_new_data)
        future.add_done_callback(forget)
        return future


def wire_receiver(buffer: Any, authority: str) -> Callable[[tuple[Any, ...]], None] | None:
    """Return the function that stores the wire tuple of a TFMessage in the buffer. Return None if a program has replaced
    `set_transform`.
    """
    if type(buffer).set_transform is not Buffer.set_transform or 'set_transform' in vars(buffer):
        return None
    set_wire = buffer._set_wire

    def receive(wire: tuple[Any, ...]) -> None:
        for transform in wire[0]:
            set_wire(transform, authority)

    return receive


__getattr__ = passed_on(__name__)
