from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.errors import UnusableInput
from edulaunch.extras.comparing.differing import Difference
from edulaunch.extras.comparing.known import Known, read_known, split
from edulaunch.extras.comparing.sweep import Row, gone

TABLE = """
- {file: '*/a.launch.py *', kind: node, name: /x*, why: x is elsewhere}
- {file: '*', kind: output, real: missing, why: chance, sometimes: true}
"""
NODE, LINE = Difference('node', '/x1', 'there', 'missing'), Difference('output', 'p', 'text', 'missing')


def table(folder: Path, text: str = TABLE) -> list[Known]:
    (folder / 'known.yaml').write_text(text)
    return read_known(str(folder / 'known.yaml'))


def test_a_row_explains_what_all_its_patterns_fit(tmp_path: Path) -> None:
    known = table(tmp_path)
    other = Difference('node', '/y', 'there', 'missing')
    found = [NODE, LINE, other]
    assert split(known, ('d/a.launch.py', 'n:=1'), found) == ([other], known)
    assert split(known, ('d/b.launch.py',), found) == ([NODE, other], [known[1]])
    assert split([], ('d/a.launch.py', 'n:=1'), found) == (found, [])


def test_what_is_known_and_does_not_occur_is_told_unless_it_is_chance(tmp_path: Path) -> None:
    known = table(tmp_path)
    words = 'd/a.launch.py', 'n:=1'
    assert gone(known, [Row(words)]) == [known[0]]
    assert gone(known, [Row(words, (), (known[0],))]) == []
    assert gone(known, [Row(words, problem='took too long')]) == []
    assert gone(known, [Row(('d/b.launch.py',))]) == []


@pytest.mark.parametrize('text', ['- {file: x}', '- {file: x, why: y, colour: z}', '- 3', '{', 'no list'])
def test_what_is_no_such_table_is_refused(tmp_path: Path, text: str) -> None:
    with pytest.raises(UnusableInput, match='is not a table of known differences') as refused:
        table(tmp_path, text)
    assert 'file and why are required' in str(refused.value.help)


def test_no_table_knows_nothing(tmp_path: Path) -> None:
    assert table(tmp_path, '# nothing\n') == []


def test_no_row_of_the_sweep_explains_a_whole_file() -> None:
    rows = read_known(str(Path(__file__).with_name('known.yaml')))
    assert [row for row in rows if (row.kind, row.name) == ('*', '*')] == []
