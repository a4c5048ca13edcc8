"""What of a lesson's cells comes onto a page."""

from __future__ import annotations

from typing import Any

from edulaunch.course.lesson_parts import Part, lesson_parts, markdown
from edulaunch.course.notebook_file import Cell
from edulaunch.course.questions import Explanation, Questions


def text(source: str) -> Cell:
    return Cell('text', 'markdown', source)


def code(ident: str, source: str) -> Cell:
    return Cell(ident, 'code', source)


def parts(*cells: Cell, teacher: bool = False, **outputs: Any) -> list[Part]:
    given = {ident.replace('_', '-'): output for ident, output in outputs.items()}
    questions = Questions({}, {'why': Explanation('why', '01', 'Because.')})
    return list(lesson_parts(cells, given, questions, teacher))


def said(words: str) -> list[dict[str, Any]]:
    return [{'output_type': 'stream', 'name': 'stdout', 'text': words}]


def result(plain: str, **more: str) -> list[dict[str, Any]]:
    return [{'output_type': 'execute_result', 'data': {'text/plain': plain, **{k.replace('_', '/'): v for k, v in more.items()}}}]


def test_what_comes_between_guess_and_answer_is_folded() -> None:
    cells = [
        code('guess', "predict('green', ...)  # 0 to 255"),
        code('get', '%ros2 param get'),
        code('was', "compare('green', 86)"),
    ]
    cells.append(code('on', 'print(1)'))
    outputs = {
        'guess': result('No prediction yet: ...'),
        'get': said('86'),
        'was': result('The result is 86. You made no prediction'),
        'on': said('1'),
    }
    found = parts(*cells, **outputs)
    assert [(part.kind, part.text, part.folded) for part in found] == [
        ('guess', '0 to 255', False),
        ('code', '%ros2 param get', True),
        ('code', 'print(1)', False),
    ]
    found = parts(*cells, teacher=True, **outputs)
    assert [(part.kind, part.text, part.folded) for part in found][1:3] == [
        ('code', '%ros2 param get', False),
        ('answer', '86', False),
    ]


def test_a_prediction_said_aloud_is_folded_until_the_next_text() -> None:
    cells = [
        text('**Predict:** what?'),
        code('file', '%%writefile a.py\nx = 1'),
        code('run', 'run()'),
        text('So.'),
        code('on', 'on()'),
    ]
    found = parts(*cells, file=said('Writing a.py'), run=said('2'), on=said('3'))
    assert [part.folded for part in found if part.kind == 'code'] == [False, True, False]
    assert (found[1].file, found[1].text, found[1].outputs) == ('a.py', 'x = 1', ())


def test_the_other_lines_of_a_comparing_cell_stay() -> None:
    cell = code('both', "run = launch()\ncompare('nodes', len(run.nodes))")
    found = parts(cell, both=[*said('started'), *result('The result is 3. You made no prediction')])
    assert [(part.kind, part.text) for part in found] == [('code', 'run = launch()')]
    assert [output.text for output in found[0].outputs] == ['started']


def test_an_explanation_is_a_place_to_write_and_a_folded_answer() -> None:
    found = parts(code('x', "explain('why', ...)"), x=result('Replace the three dots ...'))
    assert [part.kind for part in found] == ['guess', 'text']
    assert found[1].text.startswith('<details>') and 'Because.' in found[1].text


def test_outputs_are_shown_in_their_best_form() -> None:
    error = [{'output_type': 'error', 'ename': 'E', 'evalue': 'v', 'traceback': ['\x1b[31mE\x1b[0m: v']}]
    replay = (
        '<div><img src="data:image/svg+xml;base64,PHN2Zy8+"><iframe title="t" srcdoc="&lt;p&gt;desk&lt;/p&gt;"></iframe></div>'
    )
    cells = [code(name, 'x') for name in ('error', 'table', 'words', 'replay', 'html', 'kept')]
    found = parts(
        *cells,
        error=error,
        table=result('a  b', text_html='<table></table>'),
        words=result('It rains', text_html='<div>It rains</div>'),
        replay=result('replay of 2 s', text_html=replay),
        html=result('<IPython.core.display.HTML object>', text_html='<b>long</b>'),
        kept=result('t=2 s', image_png='', text_html=''),
    )
    shown = [part.outputs[0] for part in found]
    assert [output.kind for output in shown] == ['error', 'html', 'text', 'replay', 'html', 'picture']
    assert shown[0].text == 'E: v' and shown[3].page == '<p>desk</p>' and shown[3].data == b'<svg/>' and shown[5].data == b''


def test_a_dollar_in_code_is_no_formula() -> None:
    html = markdown('Write `$(var x)` or `${y}`, in\n\n```\n$(z) $(z)\n```\n\nand $a_1$.')
    assert '$(var x)' in html and '${y}' in html and '$(z) $(z)' in html and html.count('class="formula"') == 1
    assert '<code>\\undrawable</code>' in markdown('$\\undrawable$')
