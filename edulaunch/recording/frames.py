"""The tf frames of a recording at a time: what a listener that heard everything would know."""
from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.recording.records import Frame

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording


def frames_at(recording: Recording, time_s: float) -> dict[str, Frame]:
    """See `Recording.frames_at`. Among dynamic transforms the newest stamp counts; the last one published, among equals."""
    found: dict[str, Frame] = {}
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
                        transform.header.frame_id, (move.x, move.y, move.z), (turn.x, turn.y, turn.z, turn.w), is_static, stamp_s)
    return found
