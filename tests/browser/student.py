"""A student who goes through a lesson in JupyterLab: types guesses, writes wrong and right, answers questions, drives."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from edulaunch.course.questions import Questions
from tests.browser.answers import ANSWERS, Edit
from tests.browser.lab import WAIT_MS, Page
from tests.lessons.notebook import Cell, Lesson

FIND = """ident => {
  const notebook = window.jupyterapp.shell.currentWidget.content;
  return notebook.widgets.findIndex(cell => cell.model.id === ident);
}"""
EDIT = """async index => {
  const notebook = window.jupyterapp.shell.currentWidget.content;
  notebook.activeCellIndex = index;
  await notebook.scrollToItem(index, 'center');
  notebook.activate();
  notebook.mode = 'edit';
  notebook.activeCell.editor.focus();
}"""
RUN = """async index => {
  const notebook = window.jupyterapp.shell.currentWidget.content;
  notebook.activeCellIndex = index;
  notebook.deselectAll();
  await window.jupyterapp.commands.execute('notebook:run-cell');
}"""
SOURCE = 'index => window.jupyterapp.shell.currentWidget.content.widgets[index].model.sharedModel.getSource()'
OUTPUTS = """index => window.jupyterapp.shell.currentWidget.content.widgets[index].model.outputs.toJSON().map(output => ({
  output_type: output.output_type, text: output.text || (output.data || {})['text/plain'] || ''}))"""
PREDICT = re.compile(r"predict\('([\w-]+)', \.\.\.\)")
QUIZ, EXPLAIN = re.compile(r"quiz\('([\w-]+)', \.\.\.\)"), re.compile(r"explain\('([\w-]+)', \.\.\.\)")
COMPARE = re.compile(r"compare\('([\w-]+)'")
CHECK = re.compile(r"(?m)^(?:edulaunch\.)?check\('(\w+)'\)")
WAS = re.compile(r'The result is (.*?)\. You made no prediction')


class BrowserStudent:
    """Somebody at one lesson, in a folder where nothing of theirs lies yet.

    :param questions: the questions and explanations of the course.
    """

    def __init__(self, page: Page, lesson: Lesson, course: Path, questions: Questions) -> None:
        self.page = page
        self.lesson = lesson
        self.course = course
        self.questions = questions
        self.guesses: dict[str, tuple[str, bool]] = {}
        self.done: list[str] = []

    def go_through(self) -> None:
        """Every code cell in its order, as the lesson asks for it."""
        for cell in self.lesson.code:
            self.guess(cell)
            told = self.run(cell.id)
            assert not self._is_error(cell.id) or 'raises-exception' in cell.tags, f'{cell.id}: {told}'
            is_told = 'Traceback' in cell.text or 'KeyboardInterrupt' in told  # Ctrl-C, after --for
            assert 'Traceback' not in told or is_told, f'{cell.id}: {told}'
            self.compared(cell, told)
            self.answer(cell)
            self.explain(cell, told)
            self.complete(cell, told)
            if cell.source.lstrip('# ').startswith('%ros2 view') and 'nbval-ignore-output' not in cell.tags:
                self.drive(cell)

    def type(self, ident: str, text: str) -> None:
        """Put the cursor into a cell, and write its whole text anew."""
        index = self.page.page.evaluate(FIND, ident)
        assert index >= 0, f'there is no cell {ident}'
        self.page.page.evaluate(EDIT, index)
        self.page.page.keyboard.press('Control+A')
        self.page.page.keyboard.insert_text(text)
        assert self.page.page.evaluate(SOURCE, index).strip() == text.strip()

    def run(self, ident: str) -> str:
        """Run one cell; returns its texts."""
        self.page.page.evaluate(RUN, self.page.page.evaluate(FIND, ident))
        return self.told(ident)

    def told(self, ident: str) -> str:
        """What stands below a cell, as text."""
        outputs = self._outputs_of(ident)
        texts = [one['text'] for one in outputs]
        return '\n'.join(text if isinstance(text, str) else ''.join(text) for text in texts)

    def guess(self, cell: Cell) -> None:
        """Type a prediction: what is right at every second one, something else at the others."""
        for name in PREDICT.findall(cell.source):
            right = self._answer_to(name)
            is_right = right is not None and len(self.guesses) % 2 == 1
            said = str(right) if is_right else 'something else'
            self.guesses[name] = said, is_right
            self.type(cell.id, cell.source.replace('...', repr(said), 1))

    def compared(self, cell: Cell, told: str) -> None:
        """What was said is held against what happened."""
        for name in COMPARE.findall(cell.source):
            said, is_right = self.guesses[name]
            assert f'You predicted {said}, the result is' in told, f'{cell.id}: {told}'
            assert 'exactly' in told or ': right' in told or not is_right, f'{cell.id}: {told}'

    def answer(self, cell: Cell) -> None:
        """Choose a wrong answer first; the comment says why it is wrong. Then the right one."""
        found = QUIZ.search(cell.source)
        if found is None:
            return
        question = self.questions.questions[found[1]]
        letters = 'abcdefgh'[: len(question.choices)]
        wrong = next(letter for letter in letters if letter != question.right)
        self.page.show(cell.id, cell.id)
        for letter in (wrong, question.right):
            self.type(cell.id, cell.source.replace('...', repr(letter), 1))
            assert question.choices[letters.index(letter)].feedback in self.run(cell.id)
        self.page.show(cell.id, f'{cell.id}-answered')
        self.done.append(found[1])

    def explain(self, cell: Cell, told: str) -> None:
        """Write an explanation; only then the answer is shown."""
        found = EXPLAIN.search(cell.source)
        if found is None:
            return
        answer = self.questions.explanations[found[1]].answer
        assert answer not in told
        self.type(cell.id, cell.source.replace('...', repr('because the name is not the same'), 1))
        told = self.run(cell.id)
        assert answer in told and 'because the name is not the same' in told, told
        self.page.show(cell.id, f'{cell.id}-written')
        self.done.append(found[1])

    def complete(self, cell: Cell, told: str) -> None:
        """What is asked for is not there yet, and the check says so; then it is written, and the check says done."""
        found = CHECK.search(cell.source)
        if found is None:
            return
        assert re.search('FAILED|not yet|does not exist', told), f'{cell.id}: {told}'
        edits = ANSWERS.get((self.lesson.name, cell.id))
        if edits is None:
            return
        for edit in edits:
            self.write(edit, before=cell)
        told = self.run(cell.id)
        assert 'all passed' in told, f'{cell.id}: {told}'
        self.page.show(cell.id, f'{cell.id}-done')
        self.done.append(found[1])

    def write(self, edit: Edit, before: Cell) -> None:
        """Change the cell that writes a file and run it, or the file where no cell does."""
        path, old, new = edit
        cells = [cell for cell in self.lesson.code if cell.id == path or (cell.file or ('',))[0] == path]
        if not cells:
            place = self.course / 'lessons' / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(new if not old else _replaced(place.read_text('utf-8'), old, new, path), encoding='utf-8')
            return
        cell = cells[-1]
        source = self.page.page.evaluate(SOURCE, self.page.page.evaluate(FIND, cell.id))
        first = source.split('\n', 1)[0] + '\n' if cell.file is not None else ''
        self.type(cell.id, first + new if not old else _replaced(source, old, new, path))
        if cell.id != before.id:
            self.run(cell.id)

    def drive(self, cell: Cell) -> None:
        """Time goes on as soon as the desk is open: press a key on the first picture, look on for a moment, and stop it."""
        self.page.show(cell.id)
        box = self._outputs(cell.id)
        box.locator('.state').filter(has_text='running').first.wait_for(timeout=WAIT_MS)
        clock = box.locator('.clock').first
        before = _seconds(clock.inner_text())
        self.page.page.keyboard.press('ArrowUp')
        self.page.page.wait_for_function(
            '([clock, before]) => parseFloat(clock.innerText) > before + 0.2',
            arg=[clock.element_handle(), before],
            timeout=WAIT_MS,
        )
        self.page.show(cell.id, f'{cell.id}-driven')
        box.locator('button[title^="play or pause"]').first.click()
        box.locator('.state').filter(has_text='paused').first.wait_for(timeout=WAIT_MS)

    def _outputs(self, ident: str) -> Any:
        """The outputs of a cell on the page."""
        index = self.page.page.evaluate(FIND, ident)
        return self.page.page.locator(f'.jp-Cell[data-windowed-list-index="{index}"] .jp-OutputArea').first

    def _is_error(self, ident: str) -> bool:
        return any(output['output_type'] == 'error' for output in self._outputs_of(ident))

    def _outputs_of(self, ident: str) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = self.page.page.evaluate(OUTPUTS, self.page.page.evaluate(FIND, ident))
        return found

    def _answer_to(self, name: str) -> str | None:
        """What happens in the end, by the stored output of the cell that compares."""
        texts = (cell.text for cell in self.lesson.code if name in COMPARE.findall(cell.source))
        found = next((found for found in map(WAS.search, texts) if found is not None), None)
        return None if found is None else found[1]


def _replaced(text: str, old: str, new: str, where: str) -> str:
    assert text.count(old) == 1, f'{old!r} is {text.count(old)} times in {where}'
    return text.replace(old, new)


def _seconds(text: str) -> float:
    return float(text.split()[0])
