"""The examples: for each rule a failing and a healthy one, as a student would write it, and what is told of the failing one.

`examples/RULE/` has `failing` and `healthy` (`.py`: a program; `.launch.py`, `.launch.xml`, `.launch.yaml`: a launch file; a folder:
`main.launch.*` or `main.py` in it is run, or, for rules over sources, it is the workspace) and `told.txt`.
A first line `# run: radius:=3 --for 10` gives launch arguments, and simulated seconds (default: 5); `--interrupted`: Ctrl-C then.

`python -m tests.advice.harness [RULE...]` writes `told.txt` anew: read what changed before you commit it.
"""

from __future__ import annotations

import os
import sys
from functools import cache
from pathlib import Path

import edulaunch
from edulaunch.advice import Finding, judge, judge_plan, judge_sources, rendered
from edulaunch.advice.reader import Reader
from edulaunch.advice.rule import KINDS, all_rules, rules_over
from edulaunch.runtime.session import Session

EXAMPLES = Path(__file__).parent / 'examples'
WITHOUT = {
    *('packages.build-output-committed', 'programs.rule-failed'),
    *('packages.built-before', 'packages.not-searched'),
    *('programs.alone-on-network', 'time.other-clock', 'messages.other-definition'),  # tests/extras/network/test_advice.py
}
"""Nothing that a student writes, or that a repository can hold, makes these speak; or it depends on the current folder."""
ENDINGS = ('.launch.py', '.launch.xml', '.launch.yaml', '.py', '')


def example(rule: str, which: str) -> Path:
    """The file or folder of a rule's 'failing' or 'healthy' example."""
    places = [EXAMPLES / rule / f'{which}{ending}' for ending in ENDINGS]
    return next((place for place in places if place.exists()), places[0])


@cache
def findings(rule: str, which: str) -> list[Finding]:
    """All that is found in an example, not by its own rule alone."""
    path = example(rule, which)
    kind = next(kind for kind in KINDS if any(one.name == rule for one in rules_over(kind)))
    if kind in ('sources', 'workspaces'):
        return judge_sources(str(path))
    file = _main(path)
    arguments, seconds, is_interrupted = _wanted(file)
    if kind == 'plans':
        from edulaunch.advice.plan import rehearse

        with Session(workspaces=[path] if path.is_dir() else []) as session:
            return judge_plan(
                rehearse(str(file), arguments, session.index, session.host.env, command_set=session.host.command_set)
            )
    return judge(_run(path, file, arguments, seconds, is_interrupted))


def _run(path: Path, file: Path, arguments: dict[str, str], seconds: float, is_interrupted: bool) -> edulaunch.Recording:
    with Session(workspaces=[path] if path.is_dir() else []) as session:
        if '.launch.' in file.name:
            session.launch(file, None, arguments)
        else:
            session.launch(EXAMPLES / 'program.launch.py', None, {'file': str(file)})
        session.run(seconds)
        if is_interrupted:
            session.recorder.note(None, 'interrupted', '')
        return session.recording()


def _main(path: Path) -> Path:
    return next(iter(sorted(path.glob('main.*'))), path) if path.is_dir() else path


def _wanted(file: Path) -> tuple[dict[str, str], float, bool]:
    """Launch arguments, simulated seconds and whether it is broken off, from the first line."""
    try:
        words = file.read_text(encoding='utf-8').partition('\n')[0].split()
    except UnicodeDecodeError:
        return {}, 5.0, False
    seconds = float(words[words.index('--for') + 1]) if '--for' in words else 5.0
    return dict(word.split(':=') for word in words if ':=' in word), seconds, '--interrupted' in words


def told_text(rule: str, found: list[Finding]) -> str:
    """Findings as `told.txt` has them: each with its sentences, the example's folder left out."""
    blocks = []
    for one in found:
        words = rendered(one, Reader(folder=str(EXAMPLES / rule)))
        parts = (f'[{one.rule}] {words.what}', f'where: {words.where}', f'why: {words.why}', f'do: {words.do}')
        blocks.append('\n'.join(part for part in parts if not part.endswith(': ')))
    return '\n\n'.join(blocks).replace(str(EXAMPLES) + os.sep, '') + '\n'


def main(names: list[str]) -> None:
    """Write the golden texts."""
    for name in names or sorted({*all_rules()} - WITHOUT):
        (EXAMPLES / name / 'told.txt').write_text(told_text(name, findings(name, 'failing')), encoding='utf-8')


if __name__ == '__main__':
    edulaunch.source()
    main(sys.argv[1:])
