"""The command ``edugrade similar RESULTS``."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from typing import Any

from edulaunch.errors import UnusableInput

from ..batch.store import Store
from ..course import find_course, read_course
from ..cpu_limit import TooLong, cpu_limit
from ..submission import Submission
from ..terminal import printable
from ..verify import find_submission
from ..whole_file import write_whole
from .fingerprints import Code, fingerprints
from .page import similar_page
from .pairs import Work, alike

LONGEST_S = 20.0  # for the fingerprints of one submission


def main(words: Sequence[str]) -> int:
    """Print the pairs, and write the page when one is wanted. Whatever is found, the exit code is 0: nobody is judged here."""
    parser = argparse.ArgumentParser(
        prog='edugrade similar', description='Show submissions that are more alike than the task makes them.'
    )
    parser.add_argument('results', metavar='RESULTS', help='the folder that edugrade batch has written')
    parser.add_argument('--exercise', metavar='NAME', help='of which exercise (default: each)')
    parser.add_argument('--least', type=_share, default=0.6, metavar='PERCENT', help='how much of the code (default: 60)')
    parser.add_argument('--html', metavar='FILE', help='write them side by side too')
    options = parser.parse_args(words)
    results = [result for result in Store(options.results).all() if 'rubric' in result]
    names = sorted({result['rubric']['name'] for result in results})
    if options.exercise is not None and options.exercise not in names:
        raise UnusableInput(f'there are no results of {options.exercise}', help=f'there are: {", ".join(names)}')
    pages = []
    for name in [options.exercise] if options.exercise else names:
        works, lost = _works([result for result in results if result['rubric']['name'] == name], options.results)
        pairs = alike(works, _handed_out(name), options.least)
        pages.append(similar_page(name, pairs))
        print(f'{name}: {len(works)} submissions, {len(pairs)} pairs with at least {options.least:.0%} of their code in common')
        for pair in pairs:
            print(printable(f'  {pair.code:4.0%} code {pair.graph:4.0%} launch graph  {pair.one.path}  {pair.two.path}'))
        if lost:
            print(printable('  not found with the text that was graded: ' + ', '.join(lost)))
    if options.html is not None:
        write_whole(options.html, '\n'.join(pages))
    return 0


def _works(results: Sequence[dict[str, Any]], folder: str) -> tuple[list[Work], list[str]]:
    """The submissions with their texts, and the paths of those whose texts are no longer there."""
    works, lost = [], []
    for result in results:
        try:
            submission = Submission(find_submission(result, os.path.join(folder, f'{result["path"]}.json')))
        except UnusableInput:
            lost.append(str(result['path']))
            continue
        try:
            with cpu_limit(LONGEST_S):
                texts = _texts(submission)
        except TooLong:  # a text that was made to be slow
            lost.append(str(result['path']))
            continue
        works.append(Work(result['student'], result['path'], texts, tuple(map(str, result.get('graph') or ()))))
    return works, lost


def _texts(submission: Submission) -> dict[str, Code]:
    return {name: fingerprints(text) for name, text in submission.source.texts().items()}


def _handed_out(name: str) -> set[int]:
    """Fingerprints of the exercise's stub, when the course has it here."""
    try:
        manifest = find_course(os.getcwd())
        entry = next((entry for entry in read_course(manifest) if entry.name == name), None)
        places = [os.path.join(os.path.dirname(manifest), *inside) for inside in ((), ('exercises',))]
        for place in places:
            path = os.path.join(place, entry.path) if entry else ''
            if os.path.exists(path):
                return {number for code in _texts(Submission(path)).values() for number in code.prints}
    except UnusableInput:
        pass
    return set()


def _share(text: str) -> float:
    try:
        percent = float(text.rstrip('%'))
    except ValueError:
        percent = -1.0
    if not 0 <= percent <= 100:
        raise argparse.ArgumentTypeError(f'{text} is not a number from 0 to 100')
    return percent / 100
