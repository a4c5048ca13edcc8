"""Parameters with their values and where these came from, as a table."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.canvas.picture import scene_data

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording

HEADS = ('node', 'parameter', 'value', 'origin')
ALIKE_EVERYWHERE = ('use_sim_time', 'start_type_description_service')
"""Parameters that each node has; shown only when they were given a value."""


class Row(NamedTuple):
    """One parameter; `value` is written as YAML would."""

    node: str
    parameter: str
    value: str
    origin: str


class Table:
    """Rows for people: a notebook shows them as a table, `print()` as text; `repr()` is one line."""

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
        """The rows as an HTML table. A value that somebody gave is bold."""
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
    """The rows of one node or of all; `every` adds what each node has anyway."""
    names = list(dict.fromkeys(record.name for record in recording.nodes)) if node is None else [node]
    return [
        Row(name, parameter, yaml_text(value), origin)
        for name in names
        for parameter, (value, origin) in recording.parameters(name).items()
        if every or origin != 'default' or not (parameter in ALIKE_EVERYWHERE or parameter.startswith('qos_overrides.'))
    ]


def yaml_text(value: Any) -> str:
    """A parameter's value as one writes it in a parameter file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return f'[{", ".join(map(yaml_text, value))}]'
    return repr(value) if isinstance(value, str) else str(value)
