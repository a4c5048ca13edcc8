"""The seed plans, and an index laid out as it was when they were made."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.packages import Index
from edulaunch.engine.processes.commands import CommandSet
from edulaunch.ros.sources import read_source
from edulaunch.runtime.shell import SimulatedShell

SEEDS = Path(__file__).resolve().parents[3] / '..' / 'shared' / 'seeds'
FILES = (SEEDS / 'files').resolve()


def seed_rows() -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """(row of index.json, oracle entry) of every launch file that has an oracle."""
    if not (FILES / 'index.json').is_file():
        return []
    rows = json.loads((FILES / 'index.json').read_text(encoding='utf-8'))
    return [(row, entry) for row in rows if isinstance(row.get('oracle'), list) for entry in row['oracle']]


def xacro(process: Any) -> int:
    """The oracle's xacro only printed the file."""
    process.is_recorded = False
    process.write('stdout', Path(process.argv[1]).read_text(encoding='utf-8'))
    return 0


TOOLS = CommandSet({'xacro': xacro}, SimulatedShell())


class Places:
    """The prefixes of the oracle, by the names that the README of the seeds gives them."""

    def __init__(self, root: Path) -> None:
        stand_ins = {path.name: path for path in (FILES / 'stand_ins').iterdir()}
        stand_ins['my_robot_package'] = FILES / 'launch_and_parameters/my_robot_package'
        self.standin = root / 'standin'
        for package, source in stand_ins.items():
            shutil.copytree(source, _share(self.standin, package))
        self.stage1 = root / 'stage1'
        self._fill_stage1(_share(self.stage1, 'launch_tutorial'))
        self._tools = root / 'bin'
        self._tools.mkdir()
        script = self._tools / 'xacro'
        script.write_text('found on the PATH, and run by `xacro` above', encoding='utf-8')
        script.chmod(0o755)

    def _fill_stage1(self, share: Path) -> None:
        """launch_tutorial as of section 2: the final launch files, with the early ones over them."""
        early = FILES / 'large_projects/stage1'
        shutil.copytree(FILES / 'large_projects/launch_tutorial/launch', share / 'launch')
        (share / 'config').mkdir()
        for path in early.iterdir():
            shutil.copy(path, share / ('config' if path.suffix == '.yaml' else 'launch'))

    def index(self, file: str) -> Index:
        """What the oracle had for this file, all other packages being placeholders."""
        if file.startswith('large_projects/stage1/'):
            return Index([self.stage1, self.standin], underlay=None)
        return Index([self.standin], [FILES], read_source=read_source, underlay=None)

    def environ(self) -> dict[str, str]:
        return {'USER': 'student', 'PATH': f'{self._tools}:/usr/bin:/bin'}

    def normalised(self, plan: Any, index: Index) -> Any:
        """The plan with its paths as the README writes them."""
        text = json.dumps(plan)
        final = index.search_paths()[0]
        for path, name in ((self.standin, '@STANDIN'), (self.stage1, '@STAGE1'), (final, '@FINAL'), (FILES, '@FILES')):
            text = text.replace(str(path), name)
        text = re.sub(r'[^" ]*/placeholders-[0-9a-f]{8}', '@FAKEPKGS', text)
        text = re.sub(r'[^" ]*/launch_params_\w+', '@PARAMS', text)
        return json.loads(re.sub(r'@[A-Z0-9]+/lib/', '@EXEC/', text))


def _share(prefix: Path, package: str) -> Path:
    markers = prefix / 'share/ament_index/resource_index/packages'
    markers.mkdir(parents=True, exist_ok=True)
    (markers / package).write_text('', encoding='utf-8')
    return prefix / 'share' / package


@pytest.fixture(scope='session')
def places(tmp_path_factory: pytest.TempPathFactory) -> Places:
    if not FILES.is_dir():
        pytest.skip('../shared/seeds is not there')
    return Places(tmp_path_factory.mktemp('plan'))
