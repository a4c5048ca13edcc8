"""The command ``edugrade batch``, which grades a class, and can continue after an interruption."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Sequence

from edulaunch.errors import UnusableInput

from ...files import write_whole
from ...results import BROKEN_GRADER
from ...rubrics.catalogue import exercises, find_rubric
from ...submission import exercise_of
from .entries import Entry, Finder, refuse_nothing
from .store import Result, Store
from .students import ARCHIVES
from .work import Options, grade_here, work_to_do

Results = Sequence[tuple[Entry, Result | None]]
MOST_REASONS = 5


def main(words: Sequence[str]) -> int:
    """Grade a class. Return the exit code: 0, or 3 when the grader failed, so that a submission has no verdict."""
    from ..decisions import refuse_strangers
    from .batch_options import read_batch_options

    options = read_batch_options(words)
    how = Options.of(options)
    wanted = [find_rubric('', how.rubric)[0]] if how.rubric else exercises()
    refuse_nothing(options.folder)
    store = Store(options.out or _beside(options.folder))
    with store.locked():
        entries = Finder(
            options.folder,
            store.unpacked,
            lambda name: how.rubric is not None or exercise_of(name) in wanted,
            options.name_pattern,
        ).entries()
        if not entries:
            raise UnusableInput(f'there is nothing to grade in {options.folder}', help='exercises: ' + ', '.join(wanted))
        refuse_strangers(store.folder, {name for entry in entries for name in (entry.student, entry.id)})
        todo = list(work_to_do(entries, store, how))
        if options.dask:
            from .dask_cluster import grade_there

            grade_there(options.dask, todo, store, how)
        else:
            grade_here(todo, store, how)
        results = [(entry, store.result(entry)) for entry in entries]
        new = {entry.path for entry, _ in todo}
        kept = sum(entry.path not in new and 'refused' not in (found or {}) for entry, found in results)
        _write_tables(_with_decisions(results, store), options.csv, options.html, options.junit, store)
    print(_closing(results, kept, store.folder))
    is_broken = any((found or {}).get('exit_code', BROKEN_GRADER) == BROKEN_GRADER for _, found in results)
    return BROKEN_GRADER if is_broken else 0


def _with_decisions(results: Results, store: Store) -> Results:
    """Return the results with the teacher's decisions and the duration of the runs in seconds."""
    from ..decisions import decided

    times = store.times()
    found = [(entry, {**result, 'run_s': times.get(entry.path)}) for entry, result in results if result]
    counted = {
        entry.path: result for (entry, _), result in zip(found, decided([each for _, each in found], store.folder), strict=True)
    }
    return [(entry, counted.get(entry.path)) for entry, _ in results]


def _beside(given: str) -> str:
    """Return the default directory of the results, which is in the same folder as the submissions."""
    name = given.rstrip(os.sep)
    ending = next((ending for ending in (*ARCHIVES, '.csv') if name.lower().endswith(ending) and os.path.isfile(name)), '')
    return name[: len(name) - len(ending)] + '.results'


def _write_tables(results: Results, csv: str | None, html: str | None, junit: str | None, store: Store) -> None:
    from .tables import class_csv

    if csv is not None:
        write_whole(csv, class_csv(results))
    if junit is not None:
        from ...reports.junit import junit_text

        write_whole(junit, junit_text([found for _, found in results if found]))
    if html is not None:
        from .tables import write_pages

        write_pages(html, results, store)


def _closing(results: Results, kept: int, folder: str) -> str:
    marked = sum(1 for _, found in results if found and found.get('points', {}).get('earned') is not None)
    before = f', {kept} of them from an earlier batch' if kept else ''
    closing = f'{len(results)} submissions{before}; {marked} have a mark. Results: {folder}'
    return '\n'.join([closing, *_reasons(results)])


def _reasons(results: Results) -> Iterator[str]:
    """Yield the reasons why submissions have no mark, each with the number of submissions. The most frequent reason comes
    first.
    """
    from .tables import rows

    without = Counter(
        row['first_problem'] if found else 'its result could not be saved'
        for row, (_, found) in zip(rows(results), results, strict=True)
        if (found or {}).get('points', {}).get('earned') is None
    )
    for reason, count in without.most_common(MOST_REASONS):
        yield f'No mark for {count}: {reason}'
