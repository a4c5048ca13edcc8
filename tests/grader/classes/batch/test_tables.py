"""The class page names its columns as the documentation does, and says in one word that the sandbox was complete."""

from __future__ import annotations

import pytest
from edugrade.classes.batch.entries import Entry
from edugrade.classes.batch.tables import class_page


@pytest.mark.parametrize(
    ('layers', 'shown'),
    [
        ({'files': 'held', 'network': 'held'}, '<td>complete</td>'),
        ({'files': 'held', 'view': 'not available'}, '<td>files; without view (not available)</td>'),
        ({}, '<td>not confined</td>'),
    ],
)
def test_the_page_says_whether_the_sandbox_was_complete(layers: dict[str, str], shown: str) -> None:
    found = {'checks': [], 'sandbox': layers, 'verdict': 'all passed', 'exit_code': 0, 'rubric': {'name': 'circle'}}
    page = class_page([(Entry('anna/circle.launch.py', 'Anna'), found)], {})
    assert shown in page
    assert '<h1>Marks of the class</h1>' in page and '<th>outcome</th>' in page and 'verdict' not in page
