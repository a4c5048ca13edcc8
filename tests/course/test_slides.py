"""`edulaunch course slides`: computed from a lesson."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.course.lesson_parts import Output, Part
from edulaunch.course.slides import split
from edulaunch.desk.cli.main import main

pytest.importorskip('nbconvert', reason='nbconvert is not installed')


def text(words: str) -> Part:
    return Part('text', 'a', words)


def shown(*parts: Part) -> list[list[str]]:
    return [[part.text or part.outputs[0].text for part in slide.parts] for slide in split(parts)]


def test_a_heading_begins_a_slide_and_its_name_stands_on_those_after_it() -> None:
    long = Part('code', 'b', '\n'.join('abcdefghij'), outputs=(Output('text', '1\n2\n3\n4\n5\n6\n7'),))
    slides = list(split((text('# 1. T\n\nHello.'), text('So.\n\n## 1.1 Next\n\nMore.'), long)))
    assert [slide.under for slide in slides] == ['', '', '1.1 Next']
    assert [part.text for part in slides[1].parts][:2] == ['## 1.1 Next', 'More.'] and slides[2].parts[0].kind == 'output'


def test_an_answer_is_never_on_the_slide_of_its_question() -> None:
    run = Part('code', 'b', 'run()', outputs=(Output('text', '42'),))
    assert shown(text('**Predict:** how many?'), run) == [['**Predict:** how many?', 'run()'], ['42']]
    assert shown(Part('guess', 'a', 'a number'), run, Part('answer', 'c', '42'))[0] == ['a number', 'run()']


def test_the_line_before_a_list_stays_with_it() -> None:
    long = text('# 1. T\n\n' + '\n\n'.join(f'Sentence {number}.' for number in range(5)) + '\n\nYou can\n\n- one,\n- two.')
    assert shown(long)[-1][-1] == 'You can\n\n- one,\n- two.'
    assert shown(text('So.\n\n- one'))[0] == ['So.', '- one']


def test_of_a_paragraph_the_first_sentence_is_shown_and_the_rest_is_told() -> None:
    (slide,) = split((text('`a.b` is *one* thing. It has more.\n\n**Explain:** why? And how?\n\n- one. Two.'),))
    assert [part.text for part in slide.parts] == ['`a.b` is *one* thing.', '**Explain:** why? And how?', '- one. Two.']
    assert slide.sources == ['`a.b` is *one* thing. It has more.']


def test_slides_are_one_file_that_asks_for_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(['course', 'new', str(tmp_path / 'mine')])
    out = tmp_path / 'talk.html'
    assert main(['course', 'slides', '1', str(out), '--course', str(tmp_path / 'mine'), '--kept']) == 0
    assert f'{out}: ' in capsys.readouterr().out
    page = out.read_text()
    assert page.count('<section') > 3 and 'http' not in page and '<link' not in page and 'src="' not in page
    assert main(['course', 'slides', '01_circel', '--course', str(tmp_path / 'mine')]) == 2
    assert 'did you mean 01_circle' in capsys.readouterr().err
