"""The lines of a call's dictionary keys."""

from __future__ import annotations

from pathlib import Path

import pytest
from launch_ros._parameter_origins import SHORT_CALL, key_lines

AFTER = 'Node(parameters=[{"other": 1}])\n' * 30


@pytest.mark.parametrize(
    ('call', 'expected'),
    [
        ('Node(parameters=[{"a": 1,\n "b": 2}])\n', {'a': 1, 'b': 2}),
        ('Node(\n' + '# (\n' * SHORT_CALL + 'parameters=[{"a": 1}])\n', {'a': SHORT_CALL + 2}),
        ('Node(parameters=[{r"a": 1,\n # {"no": "b"}\n u\'b\': f"{x}"}])\n', {'a': 1, 'b': 3}),
        ('Node(name="""' + '\n)' * SHORT_CALL + '""", parameters=[{"a": 1}])\n', {'a': SHORT_CALL + 1}),
    ],
)
def test_a_call_is_read_to_its_end_and_no_farther(tmp_path: Path, call: str, expected: dict[str, int]) -> None:
    path = tmp_path / 'a.launch.py'
    path.write_text(call + AFTER)
    assert key_lines(str(path), 1) == expected
