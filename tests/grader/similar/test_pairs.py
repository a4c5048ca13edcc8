"""A copy with other names, comments, order of spaces and texts is found; what everybody writes is not."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

from edugrade.cpu_limit import cpu_limit
from edugrade.similar.fingerprints import Code, fingerprints
from edugrade.similar.page import similar_page
from edugrade.similar.pairs import Work, alike

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
