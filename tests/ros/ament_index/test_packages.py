"""ament_index_python.packages, and the texts of its errors."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from ament_index_python.packages import (
    PackageNotFoundError,
    get_package_prefix,
    get_package_share_directory,
    get_package_share_path,
    get_packages_with_prefixes,
)

from edulaunch import Session
from edulaunch.engine.facts import facts_of


def test_the_first_prefix_with_the_package_wins(ask: Any, two_prefixes: tuple[str, str]) -> None:
    over, under = two_prefixes
    assert ask(lambda: get_package_prefix('alpha')) == over
    assert ask(lambda: get_package_share_directory('gamma_robot')) == f'{under}/share/gamma_robot'
    assert ask(lambda: get_package_share_path('alpha')) == Path(over) / 'share' / 'alpha'
    assert ask(get_packages_with_prefixes) == {'alpha': over, 'beta': over, 'gamma_robot': under}


def test_a_missing_package_gives_the_text_of_ros_and_help_beside_it(ask: Any, two_prefixes: tuple[str, str]) -> None:
    over, under = two_prefixes
    error = ask(lambda: get_package_share_directory('gama_robot'))
    assert isinstance(error, PackageNotFoundError)
    assert isinstance(error, KeyError)
    assert str(error) == f"\"package 'gama_robot' not found, searching: ['{over}', '{under}']\""
    assert (facts_of(error)['about'], facts_of(error)['near']) == ('packages.unknown', 'gamma_robot')


@pytest.mark.parametrize('name', ['bad/name', '', 'x', '-ab'])
def test_names_that_no_package_has_are_a_value_error(ask: Any, name: str) -> None:
    error = ask(lambda: get_package_prefix(name))
    assert (type(error), str(error)) == (ValueError, f"'{name}' is not a valid package name")


def test_a_missing_share_folder_only_warns(ask: Any, two_prefixes: tuple[str, str]) -> None:
    share = Path(two_prefixes[0]) / 'share' / 'beta'
    share.rmdir()
    with pytest.warns(UserWarning, match=f'Share directory for beta .{share}. does not exist.'):
        assert ask(lambda: get_package_share_directory('beta')) == str(share)
    assert ask(lambda: get_package_share_directory('beta', print_warning=False)) == str(share)


def test_the_path_of_a_package_is_one_of_the_program_s_own_paths(tmp_path: Path) -> None:
    (tmp_path / 'p.py').write_text("""
from pathlib import Path
from ament_index_python import get_package_share_path
share = get_package_share_path('turtlesim')
print(isinstance(share, Path), share == Path(str(share)), share.parent / 'turtlesim' == share)
""")
    (tmp_path / 'a.launch.xml').write_text('<launch><executable cmd="python3 $(dirname)/p.py"/></launch>')
    with Session() as session:
        session.launch(tmp_path / 'a.launch.xml')
        session.run(1.0)
        recording = session.recording()
    assert [piece.text for piece in recording.output if piece.text.startswith('True')] == ['True True True\n']


@pytest.mark.processes
def test_who_only_looks_for_folders_does_not_wait_for_pathlib() -> None:
    code = f"""if True:
        import sys
        sys.path[:] = {sys.path!r}
        import edulaunch
        edulaunch.source()
        from ament_index_python.packages import get_package_share_directory
        get_package_share_directory('turtlesim')
        print([name for name in ('pathlib', 'urllib.parse') if name in sys.modules])
    """
    done = subprocess.run([sys.executable, '-S', '-c', code], capture_output=True, text=True, check=False)
    assert (done.stdout, done.stderr) == ('[]\n', '')
