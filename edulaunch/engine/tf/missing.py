"""A line of help that tf2 lacks: it names the existing frames if a frame is unknown."""

from __future__ import annotations

from edulaunch.engine.tf.buffer import TransformBuffer


def explain_missing(buffer: TransformBuffer, name: str) -> str | None:
    """Return one line of help about a frame that a lookup did not find, or None if the buffer has the frame.

    The line names the nearest frames, or reports that no transform has been received.
    """
    from difflib import get_close_matches  # imported here, because only failed lookups need it

    if buffer.frame_exists(name):
        return None
    names = buffer.frame_names()
    if not names:
        return (
            f"frame '{name}': the buffer is empty. Is a broadcaster running, is the TransformListener kept "
            'in an attribute, and is the node being spun?'
        )
    if name.startswith('/') and buffer.frame_exists(name[1:]):
        return f"frame '{name}': tf2 names have no leading slash; try '{name[1:]}'"
    near = get_close_matches(name, names, n=3, cutoff=0.5)
    if near:
        choice = ' or '.join(repr(known) for known in near)
        return f"frame '{name}' is not in the buffer; did you mean {choice}?"
    return f"frame '{name}' is not in the buffer; known frames: {', '.join(sorted(names))}"
