"""The tf frames of a recording at a time: what a listener that heard everything would know."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.recording.absent import Frames
from edulaunch.recording.records import Frame

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording


def frames_at(recording: Recording, time_s: float) -> dict[str, Frame]:
    """See `Recording.frames_at`. Among dynamic transforms the newest stamp counts; the last one published, among equals."""
    found = Frames()
    for topic, is_static in (('/tf_static', True), ('/tf', False)):
        for published_s, message in recording.messages(topic):
            if published_s > time_s:
                break
            for transform in message.transforms:
                stamp = transform.header.stamp
                stamp_s = (stamp.sec * 10**9 + stamp.nanosec - recording.start_ns) / 1e9
                known = found.get(transform.child_frame_id)
                if known is None or known.is_static or stamp_s >= known.stamp_s:
                    move, turn = transform.transform.translation, transform.transform.rotation
                    found[transform.child_frame_id] = Frame(
                        transform.header.frame_id, (move.x, move.y, move.z), (turn.x, turn.y, turn.z, turn.w), is_static, stamp_s
                    )
    return found


class FrameLink(NamedTuple):
    """All that was broadcast of a child frame: its parents (more than one is a mistake), the nodes that broadcast it, how many
    times, and when first and last (seconds).
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
        """How often it was broadcast, on average; None for a static frame, or one broadcast once."""
        return None if self.is_static or self.last_s <= self.first_s else (self.messages - 1) / (self.last_s - self.first_s)


def frame_links(recording: Recording) -> dict[str, FrameLink]:
    """The links of the tf tree over the whole run, by child frame in order of first appearance."""
    found: dict[str, FrameLink] = {}
    for topic, is_static in (('/tf_static', True), ('/tf', False)):
        for published_s, node, message in _with_publishers(recording, topic):
            for transform in message.transforms:
                link = found.get(transform.child_frame_id)
                if link is None:
                    link = FrameLink(transform.child_frame_id, [], is_static, [], 0, published_s, published_s)
                for known, name in ((link.parents, transform.header.frame_id), (link.broadcasters, node)):
                    if name not in known:
                        known.append(name)
                found[link.child] = link._replace(
                    messages=link.messages + 1, last_s=published_s, is_static=link.is_static and is_static
                )
    return found


def _with_publishers(recording: Recording, topic: str) -> list[tuple[float, str, Any]]:
    """Messages with the name of the node that published them, in order of publication."""
    content = recording._content
    nodes = {row[4]: row[0] for row in content['nodes']}
    owner = {row[4]: nodes.get(row[3], '') for row in content['endpoints'] if row[0] == 'publisher'}
    senders = [
        (time, owner.get(publisher, ''))
        for column in content['topics']
        if column['topic'] == topic
        for time, publisher in zip(column['times'], column['publishers'], strict=True)
    ]
    senders.sort(key=lambda sender: sender[0])
    return [(time_s, node, message) for (_, node), (time_s, message) in zip(senders, recording.messages(topic), strict=True)]
