"""What is raised for a text with a broken `$(...)`.

Upstream parses with lark, so these errors carry the names and first lines of lark's; what follows is ours.
"""

from __future__ import annotations

from edulaunch.facts import with_facts

CONTEXT_WIDTH = 40
LONGEST_SHOWN = 60


class SubstitutionSyntaxError(Exception):
    """Base of the errors in the text of a `$(...)`."""


class UnexpectedInput(SubstitutionSyntaxError):
    """The text does not follow the grammar.

    :param position: index of the offending character.
    :param expected: what would have been allowed there, in words.
    :ivar line: line of that character within the text, from 1.
    :ivar column: its column, from 1.
    """

    def __init__(self, text: str, position: int, expected: str) -> None:
        self.pos_in_stream = position
        self.line = text.count('\n', 0, position) + 1
        self.column = position - text.rfind('\n', 0, position)
        shown = text if len(text) <= LONGEST_SHOWN else f'{text[:LONGEST_SHOWN]}...'
        with_facts(self, 'launch.call-syntax', expected_there=expected, column=self.column, text=shown)
        super().__init__(f'{self.first_line(text)}Expected one of: \n\t* {expected}\n')

    def first_line(self, text: str) -> str:
        """What lark says before it lists what it expected."""
        return 'Unexpected input. '


class UnexpectedCharacters(UnexpectedInput):
    """A character stands where the grammar does not allow it; the message shows it with a caret."""

    def first_line(self, text: str) -> str:
        """Names the character and its place, and shows both."""
        found = text[self.pos_in_stream]
        place = f'at line {self.line} col {self.column}'
        return f"No terminal matches '{found}' in the current parser context, {place}\n\n{_pointing_at(text, self.pos_in_stream)}"


class UnexpectedEOF(UnexpectedInput):
    """The text ends inside a `$(...)`."""

    def first_line(self, text: str) -> str:
        """There is nothing to show."""
        return 'Unexpected end-of-input. '


class VisitError(SubstitutionSyntaxError):
    """A `$(...)` is well-formed but cannot be made: unknown name, or wrong number of arguments.

    :ivar rule: the grammar rule, 'substitution'.
    :ivar orig_exc: the error behind it, which is also the `__cause__`.
    """

    def __init__(self, rule: str, error: Exception) -> None:
        super().__init__(f'Error trying to process rule "{rule}":\n\n{error}')
        self.rule = rule
        self.orig_exc = error


def _pointing_at(text: str, position: int) -> str:
    before = text[max(position - CONTEXT_WIDTH, 0) : position].rsplit('\n', 1)[-1]
    after = text[position : position + CONTEXT_WIDTH].split('\n', 1)[0]
    return f'{before}{after}\n{" " * len(before.expandtabs())}^\n'
