"""``edugrade course [FOLDER]``: checks that exercises, solutions, rubrics and manifest belong together.

FOLDER (default: the current folder) contains course.toml (or exercises/course.toml) and the folders exercises/ and solutions/. It
may also contain the folders rubrics/ and lessons/. The command prints each problem on a line, and the exit code is 1 if there is
one. With --quick, the command launches nothing.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice
from tempfile import TemporaryDirectory
from typing import Any

from edulaunch.engine.nearest import nearest
from edulaunch.errors import UnusableInput

from .course import LEVELS, MANIFEST, Exercise, read_course, read_toml
from .faults import raise_fault
from .files import files_below
from .grading import grade, plan_work
from .rubric import RubricMistake
from .rubrics.catalogue import ENDINGS, course_rubrics, find_rubric, load_rubric, rubrics_folder, rubrics_in
from .rubrics.yaml_lint import points_for_defaults, points_for_names
from .submission import Submission
from .variant import MARK, CourseSecret, Variant, personal

STUBS, SOLUTIONS, LESSONS = 'exercises', 'solutions', 'lessons'
QUESTIONS = 'questions.toml'  # the questions of the lessons, with their answers
SHORTEST_HINT = 40
MOST_GAPS = 3
NEEDED = {'file', 'title', 'points'}
KEYS: tuple[tuple[str, type, str], ...] = (
    ('file', str, 'a path in exercises'),
    ('title', str, 'a text'),
    ('points', int, 'a whole number'),
    ('lesson', str, 'the name of a notebook'),
    ('hints', list, 'a list of strings'),
    ('why', str, 'a text'),
    ('check_points', dict, 'a table of points'),
    ('variants', list, 'a list of lists of strings'),
)
"""The fields of an exercise in the manifest: name, type, and the type in words."""
TRIED = b'no secret: the variants that are tried'
LONGEST_GAP = 10  # lines that a solution adds or changes for each gap, on average
_BY_THE_WAY = ('__pycache__', '.ipynb_checkpoints', 'my_progress.toml', 'my_variant.toml')
MOST_STUDENTS, TRIES = 2, 400
"""The number of students whose variants are tried, and the number of students among whom they are chosen."""


def main(argv: Sequence[str] | None = None, also: Sequence[str] = ()) -> int:
    """Check the course in a folder, and print each problem. Return the exit code.

    :param argv: the words of the command line (default: the words of this process).
    :param also: problems that the caller has found.
    """
    options = course_parser().parse_args(argv)
    folder: str = options.folder
    places = [os.path.join(folder, MANIFEST), os.path.join(folder, STUBS, MANIFEST)]
    manifest = next((place for place in places if os.path.isfile(place)), places[1])
    course: list[Exercise] = []
    problems = list(listed(check_manifest(manifest)))
    if not problems:
        course = read_course(manifest)
        problems = [*listed(check_files(folder, course)), *listed(check_entries(folder, course))]
        if not options.quick:
            sound = [item for item in course if _can_be_run(folder, item)]
            problems += [*listed(check_runs(folder, sound)), *listed(check_variants(folder, sound))]
    problems = list(dict.fromkeys([*also, *problems]))
    for problem in problems:
        print(f'course: {problem}')
    if not problems:
        count = f'{len(course)} exercise' + 's' * (len(course) != 1)
        print(f'course: {count}, {sum(item.points for item in course)} points, no mistakes')
    return 1 if problems else 0


def _can_be_run(folder: str, item: Exercise) -> bool:
    """Return whether the starter file, the solution and the rubric of an exercise can be read. Other checks report the
    mistakes.
    """
    try:
        for kind in (STUBS, SOLUTIONS):
            plan_work(Submission(os.path.join(folder, kind, item.path)), _rubrics(folder)[item.name])
    except (Exception, SystemExit):
        return False
    return True


def course_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade course``."""
    parser = argparse.ArgumentParser(
        prog='edugrade course', description='Check that exercises, solutions, rubrics and manifest of a course belong together.'
    )
    parser.add_argument(
        'folder', nargs='?', default='.', metavar='FOLDER', help='folder of the course (default: the current one)'
    )
    parser.add_argument('--quick', action='store_true', help='launch nothing')
    return parser


def listed(found: Iterator[str]) -> Iterator[str]:
    """Yield the problems that a check finds. If the check raises an error, yield the error as one more problem."""
    try:
        yield from found
    except UnusableInput as error:
        yield str(error)
    except RubricMistake as error:
        yield from str(error).splitlines()
    except SystemExit as error:
        yield f'a file of the course ended the check: SystemExit: {error}'
    except Exception as error:
        raise_fault(error)
        yield f'this could not be checked to its end: {type(error).__name__}: {error}'


def check_manifest(path: str) -> Iterator[str]:
    """Yield the problems of a manifest: missing or unknown fields, fields with wrong types, and repeated files."""
    try:
        entries = read_toml(path).get('exercise')
    except (OSError, ValueError) as error:
        yield f'the manifest {path} cannot be read: {getattr(error, "strerror", None) or error}'
        return
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        yield f'the manifest {path} has no exercises: write [[exercise]] before each of them'
        return
    for number, entry in enumerate(entries, 1):
        name = entry.get('file', f'the exercise number {number}')
        for key, kind, words in KEYS:
            if key not in entry and key in NEEDED:
                yield f'{name} has no {key} in {MANIFEST}'
            elif key in entry and (
                not isinstance(entry[key], kind) or isinstance(entry[key], bool) or not _fits(key, entry[key])
            ):
                yield f'{name}: {key} is {entry[key]!r} in {MANIFEST}, and {words} is expected'
        known = [key for key, _, _ in KEYS]
        for key in (key for key in entry if key not in known):
            close = nearest(key, known)
            yield f'{name} has the unknown field {key} in {MANIFEST}' + (f'; did you mean {close}?' if close else '')
    yield from (
        f'{path} names {file} twice' for file, count in Counter(str(entry.get('file')) for entry in entries).items() if count > 1
    )


def _fits(key: str, value: Any) -> bool:
    """Return whether a value of the right type also has valid content."""
    if key == 'file':
        return value not in ('', '.') and not os.path.isabs(value) and os.pardir not in value.split('/')
    if key == 'variants':
        return all(isinstance(row, list) and row for row in value)
    return True


def check_files(folder: str, course: Sequence[Exercise]) -> Iterator[str]:
    """Yield the files and rubrics that are missing, or that belong to no exercise.

    Starter files and solutions must have equal relative paths.
    """
    stubs, solutions = (_files(os.path.join(folder, name)) for name in (STUBS, SOLUTIONS))
    solutions = [name for name in solutions if name != QUESTIONS]
    yield from (f'{SOLUTIONS}/{name} is missing' for name in stubs if name not in solutions)
    yield from (f'{STUBS}/{name} is missing' for name in solutions if name not in stubs)
    paths = [item.path for item in course]
    yield from (f'{STUBS}/{name} belongs to no exercise of {MANIFEST}' for name in stubs if name.split('/')[0] not in paths)
    yield from (f'{STUBS}/{item.file} is missing' for item in course if item.file not in stubs)
    names, rubrics = [item.name for item in course], _rubrics(folder)
    yield from (f'the rubric of {name} is missing' for name in names if name not in rubrics)
    yield from (f'the rubric {name} has no exercise in {MANIFEST}' for name in rubrics if name not in names)
    for name, file in rubrics.items():
        found = [name + ending for ending in ENDINGS if os.path.exists(os.path.join(os.path.dirname(file), name + ending))]
        if len(found) > 1:
            yield f'{name} has several rubrics, {" and ".join(found)}, and {os.path.basename(file)} counts: remove the other one'


def _rubrics(folder: str) -> dict[str, str]:
    """Return the rubrics of this course, or the rubrics of edugrade."""
    return rubrics_in(course_rubrics(folder) or rubrics_folder())


def check_entries(folder: str, course: Sequence[Exercise]) -> Iterator[str]:
    """Yield problems of titles, points, hints, lessons, variants and gaps."""
    rubrics = _rubrics(folder)
    for item in course:
        yield from listed(_entry(folder, item, rubrics))
        yield from listed(_gaps(folder, item))


def _entry(folder: str, item: Exercise, rubrics: dict[str, str]) -> Iterator[str]:
    if item.name in rubrics:
        yield from listed(_against_the_rubric(item, rubrics[item.name]))
    if len(item.hints) != LEVELS or any(len(hint) < SHORTEST_HINT for hint in item.hints):
        yield f'{item.name} needs {LEVELS} hints of at least {SHORTEST_HINT} characters'
    if not item.why and course_rubrics(folder) is None:
        yield f'{item.name} does not say why it matters on a robot: why = "..." in {MANIFEST}'
    yield from _variants(folder, item, rubrics.get(item.name))
    lesson = os.path.join(folder, LESSONS, f'{item.lesson}.ipynb')
    if item.lesson and os.path.isdir(os.path.join(folder, LESSONS)) and not os.path.isfile(lesson):
        yield f'{item.name} names the lesson {item.lesson}, which is not in {LESSONS}/'


def _variants(folder: str, item: Exercise, rubric: str | None) -> Iterator[str]:
    """Yield the rows of variants that do not have several different strings.

    Also yield the rows whose first string is missing in the starter file, the solution or the rubric.
    """
    if not item.variants or rubric is None:
        return
    texts = [Submission(os.path.join(folder, kind, item.path)).source.texts().values() for kind in (STUBS, SOLUTIONS)]
    with open(rubric, encoding='utf-8') as file:
        places = zip((STUBS, SOLUTIONS, 'its rubric'), (*texts, [file.read()]), strict=True)
    for place, found in places:
        for row in item.variants:
            if len(set(row)) < 2 or len(set(row)) < len(row):
                yield f'{item.name}: a row of variants has different texts, and more than one: {", ".join(row)}'
            elif not any(Variant('', '', {row[0]: '\0'}).of(text) != text for text in found):
                yield f'{item.name}: the variant {row[0]} does not stand in {place}'
    if all(not MARK.search(Variant('', '0' * 8, {}).stub(text)) for text in texts[0]):
        yield f'{STUBS}/{item.path} needs a line that begins with "Grade it ", because each variant gets its mark above this line'
    names = [check.name for check in load_rubric(rubric).checks]
    for variant in _tried(item, CourseSecret.of(TRIED)):
        if [check.name for check in load_rubric(rubric, variant.of).checks] != names:
            yield f'{item.name}: a variant changes the name of a check: {", ".join(variant.values)}'


def _tried(item: Exercise, secret: CourseSecret) -> list[Variant]:
    """Return a few variants in which every string differs from the usual one."""
    found = (personal(item, f'student {number}', secret) for number in range(TRIES))
    other = (variant for variant in found if variant is not None and all(key != text for key, text in variant.values.items()))
    return list(islice(other, MOST_STUDENTS))


def check_variants(folder: str, course: Sequence[Exercise]) -> Iterator[str]:
    """Yield the variants whose own solution fails their rubric, or for which the usual solution passes."""
    rubrics, secret = _rubrics(folder), CourseSecret.of(TRIED)
    with TemporaryDirectory(prefix='edugrade-variants-') as place:
        works = []
        for item, variant in [(each, variant) for each in course for variant in _tried(each, secret)]:
            usual, own = os.path.join(folder, SOLUTIONS, item.path), os.path.join(place, variant.student, item.path)
            _personal_copy(usual, own, variant)
            works.append((f'{item.name} of {variant.tag}', True, plan_work(Submission(own), rubrics[item.name], variant=variant)))
            works.append((item.name, False, plan_work(Submission(usual), rubrics[item.name], variant=variant)))
        for (name, is_own, _), report in zip(works, grade([work for *_, work in works]), strict=True):
            bad = next((result for result in report.results if result.status != 'passed'), None)
            if is_own and bad is not None:
                yield f'{name}: the solution of this variant: {bad.sentence}: {bad.reason}'
            if not is_own and bad is None:
                yield f'{name}: the usual solution passes for another variant, too: its rubric asks for none of the values'


def _personal_copy(source: str, target: str, variant: Variant) -> None:
    """Write a copy of a solution (a file or a package) with a student's values."""
    files = [source] if os.path.isfile(source) else [os.path.join(source, name) for name in _files(source)]
    for file in files:
        path = target if file == source else os.path.join(target, os.path.relpath(file, source))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(file, encoding='utf-8') as text, open(path, 'w', encoding='utf-8') as copy:
            copy.write(variant.stub(text.read()))


def check_runs(folder: str, course: Sequence[Exercise]) -> Iterator[str]:
    """Yield the starter files with gaps that do not fail in the expected way, and the solutions that fail a check."""
    rubrics = _rubrics(folder)
    paths = [(os.path.join(folder, kind, item.path), rubrics[item.name]) for kind in (STUBS, SOLUTIONS) for item in course]
    for report in grade([plan_work(Submission(path), rubric) for path, rubric in paths]):
        wanted = 1 if report.gaps else 0
        if report.exit_code != wanted:
            bad = next((result for result in report.results if result.status != 'passed'), None)
            yield f'{report.given}: {report.verdict}' + (f': {bad.sentence}: {bad.reason}' if bad else '')
        if wanted and report.results[0].status != 'passed':
            yield f'{report.given}: a stub must run: {report.results[0].reason}'


def _files(folder: str) -> list[str]:
    return sorted(files_below(folder, lambda name, inside: name not in (*_BY_THE_WAY, MANIFEST)))


def _against_the_rubric(item: Exercise, file: str) -> Iterator[str]:
    rubric = find_rubric(item.name, file)[1]
    try:
        rubric = rubric.with_points(item.check_points)
    except (ValueError, TypeError, AttributeError) as error:
        yield f'{item.name}: check_points in {MANIFEST}: {error}'
    points = sum(check.points for check in rubric.checks)
    if item.title != rubric.title:
        yield f'{item.name} is called {item.title!r} in {MANIFEST} and {rubric.title!r} in its rubric'
    if item.points != points:
        yield f'{item.name} has {item.points} points in {MANIFEST}, but its checks add up to {points}'
    if len(rubric.scenarios(0)) < 2:
        yield f'{item.name} is run only once: one set of arguments is easily guessed'
    if file.endswith('.yaml'):
        found = (*points_for_names(file), *points_for_defaults(file))
        yield from (f'the rubric of {item.name}, {problem}' for problem in found)


def _gaps(folder: str, item: Exercise) -> Iterator[str]:
    stub, solution = (Submission(os.path.join(folder, kind, item.path)) for kind in (STUBS, SOLUTIONS))
    count = len(stub.source.gaps)
    if not 1 <= count <= MOST_GAPS:
        yield f'{stub.given} has {count} comments # TODO; 1 to {MOST_GAPS} are right'
    elif _changed(stub, solution) > LONGEST_GAP * count:
        yield f'{solution.given} differs from its stub by {_changed(stub, solution)} lines; {LONGEST_GAP} a gap are enough'
    yield from (f'{gap.file}:{gap.line}: a solution has no gaps' for gap in solution.source.gaps)


def _changed(stub: Submission, solution: Submission) -> int:
    """Return the number of lines of the solution that are missing in the starter file. Docstrings and imports do not count."""
    from difflib import SequenceMatcher

    known = stub.source.bodies()
    return sum(
        b2 - b1
        for name, lines in solution.source.bodies().items()
        for kind, _, _, b1, b2 in SequenceMatcher(None, known.get(name, []), lines, autojunk=False).get_opcodes()
        if kind != 'equal'
    )


if __name__ == '__main__':
    sys.exit(main())
