"""Build the sdist and the wheel, check both, and try the wheel alone and with JupyterLab: python -m tests.release [FOLDER]

The files stay in FOLDER (default: dist). Nothing is published. The exit code is that of the first step that fails.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TOOLS = ('build', 'twine', 'check-wheel-contents')
IGNORED = 'W002,W004,W009'  # equal small files and a module name that is not one, in ROS packages; two import packages


def main(words: list[str]) -> int:
    """Run all steps; returns the exit code."""
    folder = Path(words[0] if words else ROOT / 'dist').resolve()
    if folder.exists() and any(folder.iterdir()):
        print(f'{folder} is not empty: remove it, or name another folder', file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as name:
        try:
            release(folder, Path(name))
        except subprocess.CalledProcessError as error:
            print(f'failed: {" ".join(map(str, error.cmd))}', file=sys.stderr)
            return error.returncode
    print(f'built, checked and tried: {", ".join(path.name for path in sorted(folder.iterdir()))}')
    return 0


def release(folder: Path, work: Path) -> None:
    """Build into `folder`, check what was built, and try the wheel in an empty environment and in one with JupyterLab.

    :raises subprocess.CalledProcessError: for the first step that fails.
    """
    tools = environment(work / 'tools', *TOOLS)
    run(tools / 'python', '-m', 'build', '--outdir', folder, ROOT)
    run(tools / 'twine', 'check', '--strict', *folder.iterdir())
    (wheel,) = folder.glob('*.whl')
    run(tools / 'check-wheel-contents', '--ignore', IGNORED, wheel)
    alone = environment(work / 'alone', '--require-hashes', '-r', ROOT / 'hashes.txt')
    run(alone / 'python', '-m', 'pip', 'install', '--quiet', '--no-deps', wheel)
    run(alone / 'python', '-m', 'pip', 'check')
    submission = work / 'submission'
    submission.mkdir()
    shutil.copy(ROOT / 'solutions' / 'circle.launch.py', submission)
    run(alone / 'edugrade', 'circle.launch.py', cwd=submission)
    run(alone / 'edulaunch', 'course', 'copy', 'course', cwd=submission)
    notebook = environment(work / 'notebook', '-c', ROOT / 'constraints.txt', f'{wheel}[notebook]')
    run(notebook / 'edugrade', 'circle.launch.py', cwd=submission)
    lesson = submission / 'course' / 'lessons' / '01_first_launch.ipynb'
    run(
        notebook / 'python',
        '-m',
        'nbconvert',
        '--execute',
        '--to',
        'notebook',
        '--output',
        'done.ipynb',
        lesson,
        cwd=lesson.parent,
    )


def environment(folder: Path, *installed: str | Path) -> Path:
    """Make a virtual environment with these packages; returns the folder of its commands."""
    venv.create(folder, with_pip=True)
    programs = folder / ('Scripts' if sys.platform == 'win32' else 'bin')
    run(programs / 'python', '-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', *installed)
    return programs


def run(*words: str | Path, cwd: Path = ROOT) -> None:
    """Run a program, and show what it prints.

    :raises subprocess.CalledProcessError: when it does not end with exit code 0.
    """
    print('==', ' '.join(map(str, words)), flush=True)
    subprocess.run([str(word) for word in words], cwd=cwd, check=True)


if __name__ == '__main__':
    raise SystemExit(main(sys.argv[1:]))
