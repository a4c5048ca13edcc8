"""The command ``edugrade``: reads a submission, runs it, judges the runs, and shows the report."""

from __future__ import annotations

import argparse
import errno
import io
import os
import re
import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from edulaunch.errors import UnusableInput

from .faults import REPAIR, ComputerFault, fault_of, words_of
from .files import write_whole
from .grading import Work, grade, plan_work, progress_bar
from .job import CAN_FORK, Limits
from .options import is_personal, read_options
from .rubric import RubricMistake
from .submission import Submission
from .variant import CourseSecret

if TYPE_CHECKING:
    from .results import Refusal, Report


SCHEMA = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'report.schema.json')
MAYBE_A_VERB = re.compile('[a-z][a-z_-]*')
FORKING = ('batch', 'doctor')
"""Verbs that run submissions of other people, so these must be confined."""

HEAD = ('submission', 'result', 'checks', 'points')
# with words, because a terminal may have no colours
TO_REPAIR = {'some failed': 'FAILED', 'unusable input': 'UNUSABLE', 'grader broke': 'BROKE'}


def main(argv: Sequence[str] | None = None) -> int:
    """Grade launch files and print the reports. Return the exit code."""
    words = sys.argv[1:] if argv is None else list(argv)
    try:
        code = _command(words)
        sys.stdout.flush()
        return code
    except UnusableInput as error:
        print(f'edugrade: {error}', file=sys.stderr)
        return 2
    except RubricMistake as error:
        print(f'edugrade: the rubric is wrong: {error}', file=sys.stderr)
        return 3
    except BrokenPipeError:  # a reader that stops early (``| head``) is not an error
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # otherwise, Python tries to write again at its end
        return 141
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT):
            return _broke(error)
        print(f'edugrade: the report cannot be written: {error.strerror}', file=sys.stderr)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # otherwise, Python tries to write again at its end
        return 2
    except ComputerFault as error:
        print(f'edugrade: not graded: {error}.\n  help: {REPAIR}', file=sys.stderr)
        return 3
    except Exception as error:
        return _broke(error)
    except KeyboardInterrupt:
        print('edugrade: stopped', file=sys.stderr)
        return 130


def _broke(error: Exception) -> int:
    fault = fault_of(error)
    if fault is not None:
        print(f'edugrade: not graded: {fault}.\n  help: {REPAIR}', file=sys.stderr)
        return 3
    print(f'edugrade: the grader broke: {type(error).__name__}: {error}', file=sys.stderr)
    return 3


def _command(words: list[str]) -> int:
    verb = _verb(words[0]) if words and MAYBE_A_VERB.fullmatch(words[0]) and not os.path.isfile(words[0]) else None
    if verb is not None:
        exit_code: int = verb(words[1:])
        return exit_code
    options = read_options(words)
    return _hints(options) if options.hint else _grade(options)


def _verb(word: str) -> Callable[[list[str]], int] | None:
    """Return the function of a command that a plug-in adds, or None for an unknown name.

    :raises UnusableInput: if this system cannot run the command, or the plug-in is not installed.
    """
    from edulaunch.runtime import plugins

    if word in FORKING and not CAN_FORK:
        from .in_place import NEEDED

        raise UnusableInput(f'edugrade {word}: this system has no sandbox for the code of other people', help=NEEDED)
    verb = plugins.grading_verbs().get(word)
    if verb is not None:
        found: Callable[[list[str]], int] = plugins.function(verb.function)
        return found
    error = plugins.absent(f'edugrade {word}')
    if error is not None:
        raise error
    return None


def schema_command(words: Sequence[str]) -> int:
    """Run the command ``edugrade schema``, and return its exit code."""
    argparse.ArgumentParser(prog='edugrade schema', description='Print the JSON schema of reports and results.').parse_args(words)
    with open(SCHEMA, encoding='utf-8') as file:
        print(file.read(), end='')
    return 0


def _hints(options: argparse.Namespace) -> int:
    from .attempts import find_hint, opened, progress_folder

    for path in options.paths:
        submission = Submission(path)
        print(find_hint(submission, options.hint))
        word = opened(submission.exercise, options.hint, progress_folder(submission.file))
        if word:
            print(word, file=sys.stderr)
    return 0


def _grade(options: argparse.Namespace) -> int:
    several = len(options.paths) > 1
    works, refusals = _plan(options, several)
    reports = _reports(works, options, several)
    exit_code = max([report.exit_code for report in reports] + [refusal.exit_code for refusal in refusals])
    _write(options, reports, refusals, exit_code)
    _show(_text(reports, refusals) if several else _render(reports[0]))
    _tell_of_the_sandbox(reports)
    return exit_code


def _plan(options: argparse.Namespace, several: bool) -> tuple[list[Work], list[Refusal]]:
    """Return the work for the valid paths, and a refusal for each invalid path."""
    works, refusals = [], []
    secret = CourseSecret(options.course_secret_file) if options.course_secret_file else None
    for path in options.paths:
        try:
            student, called = options.student, options.student if is_personal(options) else ''
            work = plan_work(Submission(path), options.rubric, options.seed, secret, student, options.only, called=called)
            works.append(work)
        except UnusableInput as error:
            if not several:
                raise
            from .results import Refusal

            refusals.append(Refusal(path, error.message, error.help))
        except Exception as error:  # a fault of the grader must not affect other submissions
            if not several:
                raise
            from .results import BROKEN_GRADER, Refusal

            refusals.append(Refusal(path, *words_of(error), BROKEN_GRADER))
    return works, refusals


def _reports(works: list[Work], options: argparse.Namespace, several: bool) -> list[Report]:
    from dataclasses import replace

    runs = sum(len(work.scenarios) for work in works)
    with progress_bar(runs if several else 0) as advance:
        reports = grade(works, Limits(options.limit, sandbox=options.sandbox), options.workspace, advance)
        return [_recorded(replace(report, student=options.student), options) for report in reports]


def _recorded(report: Report, options: argparse.Namespace) -> Report:
    """Return the report with the requested level of advice. Without a request, record the attempt, which determines the level."""
    from dataclasses import replace

    from .attempts import progress_folder, record_attempt

    return replace(report, level=options.advice) if options.advice else record_attempt(report, progress_folder(report.file))


def _write(options: argparse.Namespace, reports: list[Report], refusals: list[Refusal], exit_code: int) -> None:
    if options.json is not None:
        from .reports.document import document, document_of_all, json_text

        alone = len(options.paths) == 1
        write_whole(options.json, json_text(document(reports[0]) if alone else document_of_all(reports, refusals, exit_code)))
    if options.junit is not None:
        from .reports.document import document
        from .reports.junit import junit_text

        documents = [{'path': report.given, **document(report)} for report in reports]
        write_whole(options.junit, junit_text(documents, refusals))
    if options.html is not None:
        from .reports.page import page

        write_whole(options.html, page(reports, refusals))


def _render(report: Report) -> str:
    from .reports.terminal import render

    return render(report, colour=_colour())


def _text(reports: list[Report], refusals: list[Refusal]) -> str:
    """Return the reports of submissions with failed checks, followed by a summary of all submissions."""
    texts = [_render(report) for report in reports if report.exit_code]
    return '\n'.join([*texts, summary(reports, refusals)])


def summary(reports: Sequence[Report], refusals: Sequence[Refusal]) -> str:
    """Return a table with one line for each submission and the sum of the points, and the paths that could not be graded."""
    from .reports.terminal import printable

    rows = [HEAD, *(_row(report) for report in reports)]
    rows += [(refusal.given, 'REFUSED', '-', '-') for refusal in refusals]
    rows.append(('sum', _result(reports, refusals), _checks(reports), _points(reports)))
    widths = [max(len(row[column]) for row in rows) for column in range(len(HEAD))]
    lines = ['  '.join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows]
    lines.insert(1, '-' * max(map(len, lines)))
    lines.insert(-1, lines[1])
    return '\n'.join([*map(printable, lines), *_refused(refusals)]) + '\n'


def _row(report: Report) -> tuple[str, ...]:
    mark = 'no mark' if report.earned is None else f'{report.earned} of {report.possible}'
    result = TO_REPAIR.get(report.verdict, report.verdict)
    return report.given, result, f'{report.passed} of {len(report.results)}', mark


def _result(reports: Sequence[Report], refusals: Sequence[Refusal]) -> str:
    passed = sum(report.exit_code == 0 for report in reports)
    return f'{passed} of {len(reports) + len(refusals)} passed'


def _checks(reports: Sequence[Report]) -> str:
    return f'{sum(report.passed for report in reports)} of {sum(len(report.results) for report in reports)}'


def _points(reports: Sequence[Report]) -> str:
    return f'{sum(report.earned or 0 for report in reports)} of {sum(report.possible for report in reports)}'


def _refused(refusals: Sequence[Refusal]) -> list[str]:
    from .reports.terminal import printable

    lines = []
    for refusal in refusals:
        lines += ['', printable(f'{refusal.given} was not graded: {refusal.reason}')]
        lines += [printable(f'  help: {refusal.help}')] if refusal.help else []
    return lines


def _show(text: str) -> None:
    """Print a string. The exit code stays that of the report if a reader stops early (``| head``)."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors='backslashreplace')
    try:
        print(text, end='', flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _tell_of_the_sandbox(reports: list[Report]) -> None:
    from edulaunch.advice import reader_here

    from .reports.terminal import sandbox_line

    print(reader_here().retells(sandbox_line(reports)), file=sys.stderr)


def _colour() -> bool:
    return sys.stdout.isatty() and 'NO_COLOR' not in os.environ and os.environ.get('TERM') != 'dumb'
