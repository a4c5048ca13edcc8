"""All that the rules say of what is healthy or known: the corpus, the seeds, the solutions, our own packages.

`reviewed.txt` has a line for each remark: what it was said of, the rule, its subject, and behind ` -- ` a judgement: why it is true.
`python -m tests.advice.silence` writes it anew; new remarks come as `TO JUDGE`. A remark that is not true is a rule to mend.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import edulaunch
from edulaunch.advice import Finding, judge_plan, judge_sources
from edulaunch.advice.plan import rehearse
from edulaunch.runtime.session import Session
from tests.packages_corpus.cases import CASES, CORPUS
from tests.packages_corpus.journal import run_case

ROOT = Path(__file__).parents[2]
REVIEWED = Path(__file__).parent / 'reviewed.txt'
OPEN = 'TO JUDGE'
SOLUTIONS = {
    'circle.launch.py': ({}, {'circle_radius': '0.6'}),
    'follow.launch.py': ({}, {'move': 'true'}),
    'broken_follow.launch.py': ({},),
    'carrot.launch.py': ({}, {'carrot': 'moving'}),
    'static_frame.launch.py': ({}, {'height': '0.7'}),
    'large_project/launch/large_project.launch.py': ({}, {'goal': 'carrot1'}),
}


def remarks() -> list[str]:
    """Every remark, in order of what it was said of."""
    return list(dict.fromkeys([*_of_corpus(), *_of_solutions(), *_of_seeds(), *_of_share()]))


def _of_corpus() -> Iterator[str]:
    for name in CASES:
        yield from _lines(f'corpus/{name}', run_case(name).advice)
        yield from _lines(f'corpus/{name} (sources)', judge_sources(str(CORPUS / name)))


def _of_solutions() -> Iterator[str]:
    for file, given in SOLUTIONS.items():
        path = ROOT / 'solutions' / file
        workspaces = [ROOT / 'solutions' / 'large_project'] if 'large_project' in file else []
        for arguments in given:
            with Session(workspaces=workspaces) as session:
                yield from _lines(f'solutions/{file}', judge_plan(rehearse(path, arguments, session.index, session.host.env)))
            recording = edulaunch.run(path, arguments=arguments, duration_s=20.0, workspaces=workspaces, console=lambda *_: None)
            yield from _lines(f'solutions/{file}', recording.advice)


def _of_seeds() -> Iterator[str]:
    from tests import test_seeds as seeds

    with TemporaryDirectory() as folder:
        workspace = seeds.make_workspace(Path(folder)) if seeds.SEEDS.is_dir() else Path(folder)
        yield from _lines('seeds (sources)', judge_sources(str(workspace)))
        for file, oracle in seeds.RUNNING:
            given = seeds.arguments(oracle)
            path = seeds.SEEDS / 'files' / file
            with Session(workspaces=[workspace]) as session:
                yield from _lines(f'seeds/{file}', judge_plan(rehearse(path, given, session.index, session.host.env)))
            recording = edulaunch.run(path, arguments=given, duration_s=6.0, workspaces=[workspace], console=lambda *_: None)
            yield from _lines(f'seeds/{file}', recording.advice)


def _of_share() -> Iterator[str]:
    """Our own packages' launch files."""
    share = Path(edulaunch.__file__).parent / 'ros' / 'share'
    for path in sorted(share.glob('*/launch/*.launch.*')):
        recording = edulaunch.run(path, duration_s=10.0, workspaces=[], console=lambda *_: None)
        yield from _lines(f'share/{path.relative_to(share)}', recording.advice)


def _lines(place: str, findings: list[Finding]) -> Iterator[str]:
    for finding in findings:
        name = finding.name.rpartition('/')[2] if finding.kind in ('file', 'run') else finding.name
        yield f'{place}: {finding.rule} {finding.kind} {name}'


def judged() -> dict[str, str]:
    """What was said of each remark when it was reviewed."""
    rows = (line.partition(' -- ') for line in REVIEWED.read_text(encoding='utf-8').splitlines() if line)
    return {remark: judgement for remark, _, judgement in rows}


def main() -> None:
    """Write the list anew."""
    known = judged() if REVIEWED.exists() else {}
    REVIEWED.write_text(''.join(f'{line} -- {known.get(line, OPEN)}\n' for line in remarks()), encoding='utf-8')


if __name__ == '__main__':
    edulaunch.source()
    main()
