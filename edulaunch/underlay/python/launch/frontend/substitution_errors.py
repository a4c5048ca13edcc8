"""What is raised for a text with a broken `$(...)`.

Upstream parses with lark, so these errors carry the names and first lines of lark's; what follows is ours.
"""
from __future__ import annotations

CONTEXT_WIDTH = 40


class SubstitutionSyntaxError(Exception):
    """Base of the errors in the text of a `$(...)`."""


class UnexpectedInput(SubstitutionSyntaxError):
    """The text does not follow the grammar.

    :ivar line: line of the offending character within the text, from 1.
    :ivar column: its column, from 1.
    """

    def __init__(self, message: str, text: str, position: int) -> None:
        super().__init__(message)
        self.pos_in_stream = position
        self.line = text.count('\n', 0, position) + 1
        self.column = position - text.rfind('\n', 0, position)


class UnexpectedCharacters(UnexpectedInput):
    """A character stands where the grammar does not allow it; the message shows it with a caret.

    :param expected: what would have been allowed, in words.
    """

    def __init__(self, text: str, position: int, expected: str) -> None:
        super().__init__('', text, position)
        place = f'at line {self.line} col {self.column}'
        message = (f"No terminal matches '{text[position]}' in the current parser context, {place}\n\n"
                   f'{_pointing_at(text, position)}Expected one of: \n\t* {expected}\n')
        self.args = (message,)


class UnexpectedEOF(UnexpectedInput):
    """The text ends inside a `$(...)`."""

    def __init__(self, text: str, expected: str) -> None:
        super().__init__(f'Unexpected end-of-input. Expected one of: \n\t* {expected}\n', text, len(text))


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
    before = text[max(position - CONTEXT_WIDTH, 0):position].rsplit('\n', 1)[-1]
    after = text[position:position + CONTEXT_WIDTH].split('\n', 1)[0]
    return f'{before}{after}\n{" " * len(before.expandtabs())}^\n'
