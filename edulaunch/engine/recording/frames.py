"""The tf frames of a recording at a given time, as a listener that received every message would have them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from edulaunch.engine.recording.absent import RecordedFrames
from edulaunch.engine.recording.messages import Messages
from edulaunch.engine.recording.records import Frame

TF_TYPE = 'tf2_msgs/msg/TFMessage'
TOPICS = (('/tf_static', True), ('/tf', False))
"""The topics of transforms, and whether they are static, in the order in which tf2 would apply them."""


def transform_wires(recording: Messages, topic: str) -> Iterator[tuple[float, Sequence[Any]]]:
    """Yield each transform of a topic as (published in seconds, (sec, nanosec, parent, child, x, y, z, qx, qy, qz, qw)).

    No message objects are created, because a run has thousands of transforms.
    """
    for time_ns, wire in recording.wires(topic, TF_TYPE):
        for transform in wire[0]:
            yield time_ns / 1e9, transform


def frames_at(recording: Messages, time_s: float) -> dict[str, Frame]:
    """Return the frames for `Recording.frames_at`.

    The dynamic transform with the newest stamp is used or, among equal stamps, the transform that was published last.
    """
    found = RecordedFrames()
    for topic, is_static in TOPICS:
        for published_s, (sec, nanosec, parent, child, x, y, z, qx, qy, qz, qw) in transform_wires(recording, topic):
            if published_s > time_s:
                break
            stamp_s = (sec * 10**9 + nanosec - recording.start_ns) / 1e9
            known = found.get(child)
            if known is None or known.is_static or stamp_s >= known.stamp_s:
                found[child] = Frame(parent, (x, y, z), (qx, qy, qz, qw), is_static, stamp_s)
    return found


class FrameLink(NamedTuple):
    """The broadcasts of a child frame: its parents (more than one is a mistake), and the nodes that broadcast it.

    The link also contains the number of broadcasts, and the times of the first and the last broadcast in seconds.
    """

    child: str
    parents: list[str]
    is_static: bool
    broadcasters: list[str]
    messages: int
    first_s: float
    last_s: float

    @property
    def rate_hz(self) -> float | None:
        """The mean rate of broadcasts in Hz, or None for a static frame and for a frame that was broadcast only once."""
        return None if self.is_static or self.last_s <= self.first_s else (self.messages - 1) / (self.last_s - self.first_s)


def frame_links(recording: Messages) -> dict[str, FrameLink]:
    """Return the links of the tf tree over the whole run, by child frame. The frames are in order of first appearance."""
    found: dict[str, FrameLink] = {}
    for topic, is_static in TOPICS:
        for time_ns, node, wire in recording.published(topic, TF_TYPE):
            published_s = time_ns / 1e9
            for _, _, parent, child, *_ in wire[0]:
                link = found.get(child)
                if link is None:
                    link = FrameLink(child, [], is_static, [], 0, published_s, published_s)
                for known, name in ((link.parents, parent), (link.broadcasters, node)):
                    if name not in known:
                        known.append(name)
                found[child] = link._replace(
                    messages=link.messages + 1, last_s=published_s, is_static=link.is_static and is_static
                )
    return found
