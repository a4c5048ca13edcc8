"""Tables for people: parameters with their origins, messages, and log lines."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.canvas.picture import scene_data
from edulaunch.engine.recording import views
from edulaunch.engine.recording.absent import not_recorded
from edulaunch.engine.recording.fields import getter, leaf_paths

if TYPE_CHECKING:
    from edulaunch.engine.recording.recording import Recording

HEADS = ('node', 'parameter', 'value', 'origin')
ALIKE_EVERYWHERE = ('use_sim_time', 'start_type_description_service')
"""The parameters that every node has. A table shows them only if something has set them."""
MOST_ROWS = 40
LEVELS = {10: 'DEBUG', 20: 'INFO', 30: 'WARN', 40: 'ERROR', 50: 'FATAL'}


class Row(NamedTuple):
    """One parameter. `value` has the form of YAML."""

    node: str
    parameter: str
    value: str
    origin: str


class Table:
    """Rows of parameters, for people. A notebook shows a table, `print()` shows text, and `repr()` is one line."""

    def __init__(self, rows: list[Row]) -> None:
        self.rows = rows

    def __repr__(self) -> str:
        nodes = len({row.node for row in self.rows})
        given = sum(row.origin != 'default' for row in self.rows)
        return f'{len(self.rows)} parameters of {nodes} nodes, {given} of them not at their default'

    def __str__(self) -> str:
        widths = [max(len(line[column]) for line in (HEADS, *self.rows)) for column in range(len(HEADS))]
        lines = [HEADS, tuple('-' * width for width in widths), *self.rows]
        return '\n'.join(
            '  '.join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines
        )

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        return {'text/plain': f'{self}\n{self!r}', 'text/html': self.html(), **scene_data(self.rows)}

    def html(self) -> str:
        """Return the rows as an HTML table. A value that is not the default is bold."""
        head = ''.join(f'<th scope="col" style="text-align:left">{name}</th>' for name in HEADS)
        return (
            f'<table><caption style="text-align:left">{html.escape(repr(self))}</caption><thead><tr>{head}</tr></thead>'
            f'<tbody>{"".join(map(_html_row, self.rows))}</tbody></table>'
        )


def _html_row(row: Row) -> str:
    cells = [f'<code>{html.escape(text)}</code>' for text in row[:3]]
    if row.origin != 'default':
        cells[2] = f'<b>{cells[2]}</b>'
    return '<tr>' + ''.join(f'<td style="text-align:left">{cell}</td>' for cell in [*cells, html.escape(row.origin)]) + '</tr>'


def table_rows(recording: Recording, node: str | None, every: bool) -> list[Row]:
    """Return the rows of one node, or of all nodes. With `every`, include the parameters that every node has."""
    names = list(dict.fromkeys(record.name for record in recording.nodes)) if node is None else [node]
    return [
        Row(name, parameter, yaml_text(value), origin)
        for name in names
        for parameter, (value, origin) in recording.parameters(name).items()
        if every or origin != 'default' or not (parameter in ALIKE_EVERYWHERE or parameter.startswith('qos_overrides.'))
    ]


def yaml_text(value: Any) -> str:
    """Return a parameter's value in the form of a parameter file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return f'[{", ".join(map(yaml_text, value))}]'
    return repr(value) if isinstance(value, str) else str(value)


class TextTable:
    """Rows of strings under headings. A notebook shows a table, and `print()` shows text. A long table shows only its first and
    last rows.
    """

    def __init__(self, title: str, heads: tuple[str, ...], rows: list[tuple[str, ...]]) -> None:
        self.title = title
        self.heads = heads
        self.rows = rows

    def __len__(self) -> int:
        return len(self.rows)

    def _shown(self) -> list[tuple[str, ...]]:
        if len(self.rows) <= MOST_ROWS:
            return self.rows
        half = MOST_ROWS // 2
        left_out = (f'... {len(self.rows) - 2 * half} more', *[''] * (len(self.heads) - 1))
        return [*self.rows[:half], left_out, *self.rows[-half:]]

    def __str__(self) -> str:
        lines = [self.heads, *self._shown()]
        widths = [max(len(line[column]) for line in lines) for column in range(len(self.heads))]
        return '\n'.join(
            '  '.join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines
        )

    def __repr__(self) -> str:
        return f'{self.title}: {len(self.rows)} rows'

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        head = ''.join(f'<th scope="col" style="text-align:left">{html.escape(name)}</th>' for name in self.heads)
        cells = ([f'<td style="text-align:left">{html.escape(cell)}</td>' for cell in row] for row in self._shown())
        body = ''.join(f'<tr>{"".join(row)}</tr>' for row in cells)
        caption = f'<caption style="text-align:left">{html.escape(repr(self))}</caption>'
        return {'text/plain': f'{self!r}\n{self}', 'text/html': f'<table>{caption}<tr>{head}</tr>{body}</table>'}


def message_table(recording: Recording, topic: str, fields: tuple[str, ...]) -> TextTable:
    """Return the messages of a topic as a table with a column for each field.

    If no fields are given, the columns are all fields that are not lists.

    :raises NotRecorded: for an unknown topic or field.
    """
    if topic not in recording.topics:
        raise not_recorded(f'no topic {topic!r}', topic, recording.topics)
    cls = recording.message_class(recording.topics[topic].type)
    paths = fields or tuple(path for path in leaf_paths(cls))
    gets = [getter(cls, path) for path in paths]
    rows = [(f'{time:.3f}', *(_text(get(message)) for get in gets)) for time, message in recording.messages(topic)]
    return TextTable(topic, ('time', *paths), rows)


def log_table(recording: Recording, process: str | None, level: str, word: str) -> TextTable:
    """Return the log lines of a run as a table, in order of time.

    :param process: the name of one process, such as 'talker-1'; None means all processes.
    :param level: the lowest level: 'debug', 'info', 'warn', 'error' or 'fatal', in upper or lower case.
    :param word: a part of the messages, in upper or lower case; '' means all messages.
    :raises ValueError: for an unknown level.
    """
    least = next((number for number, name in LEVELS.items() if name == level.upper()), None)
    if least is None:
        raise ValueError(f'unknown level {level!r}: use one of {", ".join(LEVELS.values())}')
    rows: list[tuple[str, ...]] = [
        (f'{log.time_s:.3f}', LEVELS.get(log.level // 10 * 10, str(log.level)), log.process, log.logger, log.message)
        for log in recording.logs
        if log.level >= least and process in (None, log.process) and word.lower() in log.message.lower()
    ]
    return TextTable('log', ('time', 'level', 'process', 'logger', 'message'), rows)


def _text(value: Any) -> str:
    text = f'{value:.4g}' if isinstance(value, float) else str(value)
    return text if len(text) <= 60 else f'{text[:59]}…'


views.register(message_table=message_table, log_table=log_table)
