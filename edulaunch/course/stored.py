"""The outputs of a lesson's run, stored beside the lesson. Students get the notebook without outputs. nbval compares the stored
outputs with the outputs of a new run.

``lessons/.outputs/01_first_launch.json`` has the outputs of each code cell of ``lessons/01_first_launch.ipynb``, in order.
Pictures and HTML are not stored: nbval compares their captions and digests instead.
"""

from __future__ import annotations

import asyncio
import json
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from subprocess import DEVNULL
from tempfile import TemporaryDirectory
from typing import Any

from edugrade.progress_file import PLACE as PROGRESS

from edulaunch.engine.underlay_place import engine_folder
from edulaunch.errors import UnusableInput

from .notebook_file import read_notebook, read_outputs_file

FOLDER = '.outputs'
NOT_KEPT = ('image/png', 'image/svg+xml', 'text/html', 'application/vnd.jupyter.widget-view+json')
"""The kinds of data of which only the presence is stored."""
_folders: list[TemporaryDirectory[str]] = []
_COLOURS = re.compile(r'\x1b\[[0-9;]*m')
_IN_CELL = re.compile(r' \(line \d+ of cell \[\d+\]\)')


def outputs_file(notebook: str) -> str:
    """Return the path of the stored outputs of a notebook."""
    folder, name = os.path.split(os.path.abspath(notebook))
    return os.path.join(folder, FOLDER, f'{os.path.splitext(name)[0]}.json')


def read_outputs(notebook: str) -> dict[str, list[dict[str, Any]]]:
    """Return the stored outputs by the ID of the cell.

    :raises UnusableInput: when the outputs are missing or cannot be read.
    """
    path = outputs_file(notebook)
    try:
        return read_outputs_file(path)
    except (OSError, ValueError) as error:
        help = f'run the notebook and store its outputs with `edulaunch course store {os.path.basename(notebook)}`'
        raise UnusableInput(f'cannot read the outputs of {notebook}: {error}', help=help) from None


def store_outputs(notebook: str) -> None:
    """Run a notebook, and store the outputs of its cells in a separate file. The notebook itself contains no outputs afterwards.

    :raises UnusableInput: when a cell fails that is not tagged `raises-exception`.
    """
    folder = os.path.dirname(os.path.abspath(notebook))
    _write(outputs_file(notebook), {cell['id']: [*_kept(cell, folder)] for cell in _code(run_notebook(notebook))})
    strip(notebook)


def run_notebook(notebook: str, timeout_s: float = 120.0, called: str = '') -> Any:
    """Run a notebook in its folder, in a fresh kernel, and return it with its outputs. The file does not change.

    :param called: the name of the notebook in messages (default: its path).
    :raises UnusableInput: when a cell fails that is not tagged `raises-exception`.
    """
    import nbclient
    import nbformat

    folder, called = os.path.dirname(os.path.abspath(notebook)), called or notebook
    read: Any = nbformat.read
    if not all(cell.ident for cell in read_notebook(notebook).cells):
        raise UnusableInput(f'{called} has a cell without an id', help='open it in JupyterLab and save it again')
    try:
        done = read(notebook, as_version=4)
    except Exception as error:  # Jupyter raises many kinds of errors for an invalid notebook
        raise UnusableInput(f'cannot read {called} as a notebook: {str(error).splitlines()[0][:200]}') from None
    client = nbclient.NotebookClient(
        done, timeout=timeout_s, record_timing=False, coalesce_streams=True, resources={'metadata': {'path': folder}}
    )
    try:
        with TemporaryDirectory(prefix='edulaunch-progress-', ignore_cleanup_errors=True) as progress:
            environ = {**os.environ, PROGRESS: progress}
            # uses its own event loop, so it also works in a thread
            asyncio.run(client.async_execute(stderr=DEVNULL, env=environ))
    except nbclient.exceptions.CellTimeoutError:
        raise UnusableInput(f'{called}: a cell takes more than {timeout_s:g} s', help='simulate less time in it') from None
    except nbclient.exceptions.DeadKernelError:
        raise UnusableInput(f'{called}: the kernel died', help='run the cells one by one to find the cause') from None
    except nbclient.exceptions.CellExecutionError as error:
        help = 'if the cell should fail, give it the tag raises-exception'
        raise UnusableInput(f'{called}: {_failure(done) or error}', help=help) from None
    return done


def _failure(notebook: Any) -> str:
    """Return a description of the cell that failed and of its error, without colours and inner frames."""
    for cell in notebook['cells']:
        for output in cell.get('outputs', ()):
            if output['output_type'] == 'error' and 'raises-exception' not in cell['metadata'].get('tags', ()):
                text = ' '.join(_COLOURS.sub('', str(output['evalue'])).split())
                return f'the cell {cell.get("id", "?")} failed: {output["ename"]}: {text}'
    return ''


def strip(notebook: str) -> None:
    """Remove outputs, execution counts and editor data from a notebook."""
    _write(notebook, without_outputs(read_notebook(notebook).content))


def without_outputs(raw: dict[str, Any]) -> dict[str, Any]:
    """Remove outputs and execution counts from a notebook in place. Keep only the kernel and the tags of the metadata."""
    for cell in _code(raw):
        cell['outputs'], cell['execution_count'] = [], None
    for cell in raw['cells']:
        cell['metadata'] = {key: value for key, value in cell['metadata'].items() if key == 'tags'}
    raw['metadata'] = {'kernelspec': raw['metadata'].get('kernelspec', {}), 'language_info': {'name': 'python'}}
    return raw


def pytest_itemcollected(item: Any) -> None:
    """Add the stored outputs to nbval's cells. This is a pytest hook for the ``conftest.py`` of a folder of lessons."""
    cell = getattr(item, 'cell', None)
    if cell is None or item.path.suffix != '.ipynb':
        return
    import nbformat

    from_dict: Any = nbformat.from_dict
    cell.outputs = [from_dict(output) for output in read_outputs(str(item.path)).get(cell.id, [])]
    cell.execution_count = item.cell_num + 1
    _give_a_fresh_progress(item.parent)
    compare, folder = item.compare_outputs, os.path.dirname(item.path)

    def compare_kept(given: Any, wanted: Any) -> Any:
        plain = [from_dict(output) for output in without_place(given, folder)]
        return compare(plain, wanted, (*item.parent.skip_compare, *NOT_KEPT))

    item.compare_outputs = compare_kept


def _give_a_fresh_progress(notebook: Any) -> None:
    """Give the kernel of a notebook a separate progress file, so that nbval reads and records no attempts of a student."""
    start = notebook.setup
    if getattr(start, '__name__', '') == 'start_afresh':
        return

    def start_afresh() -> None:
        with fresh_progress():
            start()

    notebook.setup = start_afresh


@contextmanager
def fresh_progress() -> Iterator[None]:
    """Make programs that start in this context store their progress in an empty folder, which exists until this process ends."""
    folder = TemporaryDirectory(prefix='edulaunch-progress-', ignore_cleanup_errors=True)
    _folders.append(folder)
    before = os.environ.get(PROGRESS)
    os.environ[PROGRESS] = folder.name
    try:
        yield
    finally:
        os.environ.pop(PROGRESS)
        if before is not None:
            os.environ[PROGRESS] = before


def without_place(outputs: Any, folder: str) -> Any:
    """Return outputs without parts that depend on the folder and the front end.

    Such parts are the paths of the notebook's folder and of edulaunch, and line numbers in cells.
    """
    text = json.dumps(outputs)
    for place in (folder, os.path.dirname(engine_folder())):
        text = text.replace(json.dumps(place + os.sep)[1:-1], '')
    return json.loads(_IN_CELL.sub('', text))


def _code(notebook: dict[str, Any]) -> list[dict[str, Any]]:
    return [cell for cell in notebook['cells'] if cell['cell_type'] == 'code']


def _kept(cell: dict[str, Any], folder: str) -> Iterator[dict[str, Any]]:
    """Return the stored form of a cell's outputs, without execution counts, the bytes of pictures, and the path of the folder."""
    for output in without_place(cell['outputs'], folder):
        if 'execution_count' in output:
            output['execution_count'] = None
        for kind in NOT_KEPT:
            if kind in output.get('data', {}):
                output['data'][kind] = ''
        yield output


def _write(path: str, content: object) -> None:
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    with open(path, 'w', encoding='utf-8') as file:
        file.write(as_text(content))


def as_text(content: object) -> str:
    """Return a notebook, or its outputs, as a string in the form in which Jupyter writes files."""
    return json.dumps(content, indent=1, ensure_ascii=False) + '\n'
