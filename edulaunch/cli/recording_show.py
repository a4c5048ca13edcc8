"""`edulaunch recording show`: a recording as a page that plays it, or as pictures."""

from __future__ import annotations

import argparse
import os
import webbrowser

from edulaunch.errors import UnusableInput
from edulaunch.recording import Recording

PICTURES = ('turtles', 'frames', 'tree', 'graph')
TABS = ('frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters')


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Page or pictures, and what of the run."""
    parser.add_argument('file', metavar='FILE', help='a recording')
    parser.add_argument('--html', metavar='OUT', nargs='?', const='', help='write a page that plays it (default: FILE.html)')
    parser.add_argument('--png', metavar='OUT', nargs='?', const='', help='write a picture (default: FILE.png)')
    parser.add_argument('--what', choices=PICTURES, help='what the picture shows (default: turtles, or else nodes and topics)')
    parser.add_argument('--at', type=float, metavar='SECONDS', help='when (default: the end of the run)')
    parser.add_argument('--tab', choices=TABS, default='graph', help='what stands on the right side of the page')
    parser.add_argument('--open', action='store_true', help='show it in a browser')


def show(arguments: argparse.Namespace) -> int:
    """Write what is asked for, and print where it is; 0 when that went well.

    :raises UnusableInput: when it cannot be written.
    :raises NothingToDraw: when the run has nothing of the kind.
    """
    recording = Recording.load(arguments.file)
    stem = os.path.splitext(arguments.file)[0]
    written = []
    try:
        if arguments.html is not None or arguments.png is None:
            written.append(write_page(recording, arguments.html or f'{stem}.html', arguments.tab))
        if arguments.png is not None:
            written.append(write_picture(recording, arguments.png or f'{stem}.png', arguments.what, arguments.at))
    except OSError as error:
        raise UnusableInput(f'{error.filename} cannot be written: {error.strerror}') from None
    for path in written:
        print(path)
    if arguments.open:
        webbrowser.open(f'file://{os.path.abspath(written[0])}')
    return 0


def write_page(recording: Recording, path: str, tab: str = 'graph') -> str:
    """Write the page that plays a recording in any browser, without a network; returns the path."""
    from edulaunch.view.page import recorded_page
    from edulaunch.view.sources import film_of

    name = os.path.basename(recording.launch.file or '') or 'recording'
    with open(path, 'w', encoding='utf-8') as file:
        file.write(recorded_page(film_of(recording), name, tab))
    return path


def write_picture(recording: Recording, path: str, what: str | None = None, time_s: float | None = None) -> str:
    """Write a picture as PNG; returns the path. Raises NothingToDraw when the run has nothing of the kind."""
    from edulaunch.recording.absent import NothingToDraw

    if what is None:
        try:
            picture = recording.plot_turtles(time_s)
        except NothingToDraw:
            picture = recording.plot_graph()
    elif what in ('turtles', 'frames'):
        picture = recording.plot_turtles(time_s) if what == 'turtles' else recording.plot_frames(time_s)
    else:
        picture = recording.plot_tf_tree() if what == 'tree' else recording.plot_graph()
    picture.save(path)
    return path
