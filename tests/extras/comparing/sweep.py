"""All launch files at hand in simulation and for real: `python -m tests.extras.comparing.sweep [--jobs N] [--for SECONDS] [GROUP ...]`.

What differs is compared three times more, in quiet; what differs each time counts. With `--share N` all solutions, and each N-th of the others; `.ci/run` does so.

Exits with 1 when something differs that `known.yaml` does not explain.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from edulaunch.extras.comparing.known import read_known
from edulaunch.extras.comparing.sweep import Row, gone, sweep
from edulaunch.extras.comparing.verb import table
from tests.extras.comparing import places

AGAIN = (2, 2, 1)
"""What differs is compared so many times more, with so many pairs at a time; only what differs each time counts."""
KNOWN = str(Path(__file__).with_name('known.yaml'))
GROUPS = ('solutions', 'demos', 'corpus', 'lessons', 'seeds')


def items_of(group: str, folder: Path) -> places.Items:
    """The launch files of a group; those that have to be written first come into the folder."""
    place = folder / group
    place.mkdir(exist_ok=True)
    make = getattr(places, group)
    found: places.Items = make() if group in ('solutions', 'corpus') else make(place)
    return found


def both(first: Row, second: Row) -> Row:
    """What differed each time: chance does not come twice in the same way."""
    if first.problem or second.problem:
        return first if second.problem else second
    return second._replace(found=tuple(each for each in second.found if each in first.found))


def main() -> int:
    """Run it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('groups', nargs='*', default=GROUPS, metavar='GROUP', help=' '.join(GROUPS))
    parser.add_argument('--jobs', type=int, default=4)
    parser.add_argument('--for', dest='seconds', type=float, default=6.0)
    parser.add_argument('--share', type=int, default=1, metavar='N')
    parser.add_argument('--only', default='', help='what stands in the words')
    arguments = parser.parse_args()
    known = read_known(KNOWN)
    with tempfile.TemporaryDirectory() as folder:
        groups = {group: items_of(group, Path(folder)) for group in arguments.groups}
        items = [item for group in groups for item in groups[group][:: 1 if group == 'solutions' else arguments.share]]
        items = [item for item in items if arguments.only in ' '.join(item)]
        done: list[Row] = []

        def tell(row: Row) -> None:
            done.append(row)
            print(f'{len(done)} ({len(items)}) {row.verdict}: {" ".join(row.words)}', file=sys.stderr)
            for each in (*row.found, *filter(None, [row.problem])):
                print(f'    {each}', file=sys.stderr)
            sys.stderr.flush()

        def folder_of(words: Sequence[str]) -> str:
            return places.folder_of(words) or tempfile.mkdtemp(dir=folder)

        options = [f'--known={KNOWN}']
        rows = sweep(items, arguments.seconds, arguments.jobs, options, folder_of, tell)
        for jobs in AGAIN:
            again = {row.words: row for row in rows if not row.is_well}
            if not again:
                break
            print(f'{len(again)} of them once more, {jobs} at a time', file=sys.stderr)
            seen = {
                row.words: both(again[row.words], row)
                for row in sweep(list(again), arguments.seconds, jobs, options, folder_of, tell)
            }
            rows = [seen.get(row.words, row) for row in rows]
        print(table(rows))
        for each in gone(known, rows):
            print(f'a known difference did not occur: {each.file}: {each.why}')
    return 0 if all(row.is_well for row in rows) else 1


if __name__ == '__main__':
    sys.exit(main())
