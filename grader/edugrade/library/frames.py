"""What a rubric says about tf frames."""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2, cos, hypot, sin
from re import sub
from typing import TYPE_CHECKING

from ..evidence import Evidence
from ..failure import Failure, Missing

if TYPE_CHECKING:
    from edulaunch.recording.records import Frame

Frames = Mapping[str, 'Frame']


def frames_at_end(run: Evidence, scenario: str) -> Frames:
    """All frames, by name, at the end of a run."""
    recording = run[scenario]
    return run.once(('frames', scenario), lambda: recording.frames_at(recording.duration_s))


def require_frame(run: Evidence, child: str, parent: str, try_: str, hint_seen: str = '') -> None:
    """In every run tf knows a frame, and it hangs in the right parent.

    :param hint_seen: what else was seen that explains why it is missing.
    :raises Missing: when there is no such frame; names those there are.
    :raises Failure: when it hangs elsewhere.
    """
    for scenario in run:
        frames = frames_at_end(run, scenario)
        if child not in frames:
            known = ', '.join(f'{name} in {frame.parent}' for name, frame in frames.items()) or 'no frames at all'
            raise Missing(
                f'the frame {child}',
                name=child,
                among=_misspelt(child, frames),
                where=run.source.place,
                try_=try_,
                seen='\n'.join(filter(None, (known, hint_seen))),
                expected=f'the frame {child} in the frame {parent}',
            )
        if frames[child].parent != parent:
            raise Failure(
                f'{child} hangs in another frame, when launched with {run.scenario(scenario).words}',
                expected=parent,
                seen=frames[child].parent,
                where=run.source.place,
                try_=try_,
            )


def _misspelt(child: str, frames: Frames) -> list[str]:
    """The frames that could be this one misspelt: turtle1 is not turtle2 misspelt."""
    return [name for name in frames if sub(r'\d+$', '', name) != sub(r'\d+$', '', child)]


def yaw(frame: Frame) -> float:
    """How far a frame is turned about the z axis of its parent, in radians."""
    x, y, z, w = frame.rotation
    return atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def tilt(frame: Frame) -> float:
    """How far, in radians, a frame's z axis leans away from that of its parent."""
    x, y, _, _ = frame.rotation
    return 2 * atan2(hypot(x, y), 1.0)


def place_in(frames: Frames, frame: str, root: str) -> tuple[float, float] | None:
    """Where a frame's origin is on the ground plane of `root`, in metres; None when nothing leads there."""
    x = y = 0.0
    for _ in range(len(frames) + 1):
        if frame == root:
            return x, y
        link = frames.get(frame)
        if link is None:
            return None
        angle = yaw(link)
        x, y = (link.translation[0] + cos(angle) * x - sin(angle) * y, link.translation[1] + sin(angle) * x + cos(angle) * y)
        frame = link.parent
    return None


def numbers(values: tuple[float, ...]) -> str:
    """Coordinates, as a person writes them."""
    return '(' + ', '.join(f'{value + 0.0:.2f}' for value in values) + ')'
