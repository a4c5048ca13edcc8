"""A copy with other names, comments, order of spaces and texts is found; what everybody writes is not.

The command over the results of a class.
"""

from __future__ import annotations

import itertools
import json
import re
import shutil
from pathlib import Path

import pytest
from edugrade.classes.similar import Code, Work, alike, fingerprints, similar_page
from edugrade.cli import main
from edugrade.worker import cpu_limit

SOLUTION = (Path(__file__).parents[3] / 'solutions' / 'follow.launch.py').read_text()
OWN = """
def bring(turtle, number):
    settings = {'turtlename': turtle}
    for key in sorted(settings):
        print(key, settings[key], number + 1)
    return [Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name=f'b{number}', parameters=[settings])]
"""


def work(name: str, text: str, graph: tuple[str, ...] = ()) -> Work:
    return Work(name, f'{name}/follow.launch.py', {'follow.launch.py': fingerprints(text)}, graph)


def disguised(text: str) -> str:
    """Other names, comments, texts, numbers and spaces."""
    for old, new in (('bring', 'make_it'), ('turtle', 'x'), ('settings', 'conf'), ('number', 'i'), ('key', 'k')):
        text = re.sub(rf'\b{old}\b', new, text)
    return '# all mine\n' + text.replace("'", '"').replace(', ', ' ,  ').replace('+ 1', '+ 77')


def test_names_comments_and_texts_make_no_difference() -> None:
    assert set(fingerprints(OWN).prints) == set(fingerprints(disguised(OWN)).prints) != set()


def test_a_disguised_copy_is_found_and_nobody_else() -> None:
    works = [work(f's{n}', SOLUTION + f'\nx = {" + ".join("ab"[b % 2] + "[1]" * b for b in range(n))}\n') for n in range(8)]
    works += [work('anna', SOLUTION + OWN), work('bert', SOLUTION + disguised(OWN))]
    (pair, *rest) = alike(works, fingerprints(SOLUTION).prints, 0.6)
    assert {pair.one.student, pair.two.student} == {'anna', 'bert'}
    assert pair.code > 0.9


def test_a_student_is_not_alike_to_himself() -> None:
    assert alike([work('anna', OWN), work('anna', OWN)]) == []


def test_what_was_handed_out_counts_nothing() -> None:
    assert alike([work('anna', SOLUTION), work('bert', SOLUTION)], fingerprints(SOLUTION).prints) == []


def test_the_page_shows_both_and_no_markup() -> None:
    pairs = alike([work('<b>', OWN + '# <script>', ('a', 'b')), work('bert', disguised(OWN), ('a',))])
    text = similar_page('follow', pairs)
    assert '&lt;b&gt; and bert' in text and '<script>' not in text
    assert text.count('<mark>') >= 8 and 'class="same"' in text
    assert (pairs[0].code, pairs[0].graph) == (1.0, 1.0)


def test_a_hostile_text_takes_no_time() -> None:
    texts = ['"' * 100_000, "'''" + '\\' * 100_000, '(' * 100_000, '<!--' * 25_000, 'import ' * 15_000, '"a\\' * 30_000]
    for text in texts:
        with cpu_limit(20.0):
            assert isinstance(fingerprints(text), Code)
    assert list(itertools.islice(fingerprints('').prints, 1)) == []


ROOT = Path(__file__).parents[3]


@pytest.fixture
def results(tmp_path: Path) -> Path:
    text = (ROOT / 'solutions' / 'static_frame.launch.py').read_text()
    own = '\n\ndef mine(a, b):\n    return [a[index] * b ** 2 for index in range(len(b)) if a[index] > 3 and not b.get(index)]\n'
    for name, add in {'anna': own, 'bert': own.replace('index', 'i'), 'carl': ''}.items():
        (tmp_path / 'class' / name).mkdir(parents=True)
        (tmp_path / 'class' / name / 'static_frame.launch.py').write_text(text + add)
    (tmp_path / 'class' / 'dora').mkdir()
    shutil.make_archive(str(tmp_path / 'class' / 'dora' / 'work'), 'zip', tmp_path / 'class' / 'anna')
    main(['batch', str(tmp_path / 'class')])
    return tmp_path / 'class.results'


@pytest.mark.processes
def test_pairs_are_named_and_shown(
    results: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    capsys.readouterr()
    monkeypatch.chdir(ROOT)
    assert main(['similar', str(results), '--html', str(tmp_path / 'out.html'), '--least', '90']) == 0
    out = capsys.readouterr().out
    assert 'static_frame: 4 submissions, 3 pairs with at least 90% of their code in common' in out or '6 pairs' in out, out
    assert 'anna/static_frame.launch.py  bert/static_frame.launch.py' in out
    assert 'dora/work.zip/static_frame.launch.py' in out
    assert 'anna and bert' in (tmp_path / 'out.html').read_text()


@pytest.mark.processes
def test_the_launch_graph_has_no_names_in_it(results: Path) -> None:
    found = json.loads((results / 'anna' / 'static_frame.launch.py.json').read_text())
    assert found['graph'].count('starts tf2_ros/static_transform_publisher') == 2
    assert 'laser' not in str(found['graph'])


@pytest.mark.processes
def test_what_is_gone_is_said(results: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'class' / 'carl' / 'static_frame.launch.py').write_text('changed')
    assert main(['similar', str(results)]) == 0
    assert 'not found with the graded content: carl/static_frame.launch.py' in capsys.readouterr().out
    assert main(['similar', str(results), '--exercise', 'circle']) == 2
    assert main(['similar', str(tmp_path)]) == 0
