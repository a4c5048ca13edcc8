"""All frames of a buffer as a string: tf2's plain list, its YAML and its graphviz graph."""

from __future__ import annotations

from collections.abc import Mapping

from edulaunch.engine.tf.history import History

SHORTEST_SPAN_S = 0.0001  # tf2 uses this as the shortest time span when it computes a rate


def seconds(time_ns: int) -> float:
    """Convert nanoseconds to float seconds, rounded like tf2 (whole seconds and fraction separately)."""
    whole, rest = divmod(time_ns, 1_000_000_000)
    return whole + rest * 1e-9


def seconds_text(time_ns: int) -> str:
    """Return the seconds as a string with six decimals, as in tf2's messages."""
    return f'{seconds(time_ns):.6f}'


def rate(history: History) -> float:
    """Return the samples per second over the stored time span. For a single or static sample, return 10000, as tf2 does."""
    return history.count / max(seconds(history.newest - history.oldest), SHORTEST_SPAN_S)


def all_frames_as_string(frames: Mapping[str, History | None]) -> str:
    """Return one line for each frame that has or had a parent."""
    return ''.join(
        f'Frame {name} exists with parent {history.parents[-1] if history.stamps else "NO_PARENT"}.\n'
        for name, history in frames.items()
        if history is not None
    )


def all_frames_as_yaml(frames: Mapping[str, History | None]) -> str:
    """Return the YAML that `view_frames` reads: parent, broadcaster, rate and time span of each child frame."""
    if not frames:
        return '[]'
    return ''.join(_yaml_block(name, history) for name, history in _with_data(frames))


def _with_data(frames: Mapping[str, History | None]) -> list[tuple[str, History]]:
    return [(name, history) for name, history in frames.items() if history is not None and history.stamps]


def _yaml_block(name: str, history: History) -> str:
    newest, oldest = history.newest, history.oldest
    lines = [
        f'{name}: ',
        f"  parent: '{history.parents[-1]}'",
        f"  broadcaster: '{history.authority}'",
        f'  rate: {rate(history):.3f}',
        f'  most_recent_transform: {seconds_text(newest)}',
        f'  oldest_transform: {seconds_text(oldest)}',
        f'  buffer_length: {seconds(newest - oldest):.3f}',
    ]
    return '\n'.join(lines) + '\n'


def all_frames_as_dot(frames: Mapping[str, History | None], now_ns: int = 0) -> str:
    """Return a graphviz graph. With `now_ns`, it also shows the age of each newest sample, and a legend at each root."""
    if not frames:
        return 'digraph G {\n"no tf data received"}'
    edges = [_dot_edge(name, history, now_ns) for name, history in _with_data(frames)]
    legends = [_dot_legend(name, now_ns) for name, history in frames.items() if history is None and now_ns]
    return ''.join(['digraph G {\n', *edges, *legends, '}'])


def _dot_edge(name: str, history: History, now_ns: int) -> str:
    newest, oldest = history.newest, history.oldest
    age = f'( {seconds(now_ns - newest):.3f} sec old)' if now_ns else ''
    return (
        f'"{history.parents[-1]}" -> "{name}"[label="Broadcaster: {history.authority}\\n'
        f'Average rate: {rate(history):.3f} Hz\\nMost recent transform: {seconds_text(newest)} {age}\\n'
        f'Buffer length: {seconds(newest - oldest):.3f} sec\\n"];\n'
    )


def _dot_legend(root: str, now_ns: int) -> str:
    return (
        'edge [style=invis];\n'
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
        f'"Recorded at time: {seconds_text(now_ns)}"[ shape=plaintext ] ;\n}}->"{root}";\n'
    )
