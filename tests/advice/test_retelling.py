"""Finished sentences are retold by templates that are read backwards."""

from __future__ import annotations

from edulaunch.advice.retelling import Retelling

GERMAN = Retelling(
    {
        '{thing} is missing': '{thing} fehlt',
        'the frame {name}': 'das Koordinatensystem {name}',
        '{name} died {when}': '{name} ist {when} abgestürzt',
        'after {seconds:.1f} s, when launched with {words}': 'nach {seconds} s, gestartet mit {words},',
        'nothing of the kind': 'nichts dergleichen',
        'write {{}}': 'schreib {{}}',
        '{a}{b} together': '{b}{a}',
    }
)


def test_a_sentence_without_facts_is_looked_up() -> None:
    assert GERMAN('nothing of the kind') == 'nichts dergleichen'
    assert GERMAN('write {}') == 'schreib {}'


def test_facts_go_over_and_are_retold_themselves() -> None:
    assert GERMAN('the frame laser is missing') == 'das Koordinatensystem laser fehlt'
    assert GERMAN('sim-1 died after 2.0 s, when launched with a:=1') == 'sim-1 ist nach 2.0 s, gestartet mit a:=1, abgestürzt'


def test_what_is_no_sentence_of_ours_stays() -> None:
    for text in ('', 'Traceback', ' is missing', 'x' * 5000 + ' is missing', 'one two together'):
        assert GERMAN(text) == text


def test_a_hostile_text_is_matched_in_one_go() -> None:
    text = 'after ' + ' s, when launched with' * 150 + '!'
    assert GERMAN(text) == text
