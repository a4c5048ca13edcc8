"""`edulaunch recording info|show|export|diff`: summarise, show, export or compare recordings."""

from __future__ import annotations

import argparse
import os
import webbrowser
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

from edulaunch.engine.recording import Recording
from edulaunch.errors import UnusableInput
from edulaunch.ros.sourcing import source

PROCESS = ('name', 'pid', 'origin', 'started_s', 'ended_s', 'returncode')
PICTURES = ('turtles', 'frames', 'tree', 'graph')
TABS = ('launch', 'frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters')


def _file_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument('file', metavar='FILE', help='a recording')
    parser.add_argument('--trusted', action='store_true', help='read the recording without limits on its size')


def export_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options for the format and the path of the output."""
    _file_arguments(parser)
    form = parser.add_mutually_exclusive_group(required=True)
    form.add_argument('--bag', metavar='FOLDER', nargs='?', const='', help='write a bag for `ros2 bag` (default: FILE_bag)')
    form.add_argument('--mcap', metavar='OUT', nargs='?', const='', help='write one MCAP file (default: FILE.mcap)')
    form.add_argument('--csv', metavar='FOLDER', nargs='?', const='', help='write one table for each topic (default: FILE_csv)')
    parser.add_argument('--topics', nargs='+', metavar='TOPIC', help='export only these topics')
    parser.add_argument('--storage', choices=('mcap', 'sqlite3'), default='mcap', help='storage format of the bag')


def export(arguments: argparse.Namespace) -> int:
    """Write the bag, the MCAP file or the tables, and print the path. Return the exit code 0.

    :raises UnusableInput: when the file or folder exists or cannot be created, or a topic has no messages.
    :raises MissingExtra: for a bag, when rosbags is not installed.
    """
    source()
    recording = Recording.load(arguments.file, trusted=arguments.trusted)
    stem = os.path.splitext(arguments.file)[0]
    given = {'_bag': arguments.bag, '.mcap': arguments.mcap, '_csv': arguments.csv}
    folder = next(out or f'{stem}{ending}' for ending, out in given.items() if out is not None)
    if os.path.exists(folder):
        raise UnusableInput(f'{folder} already exists', help='name a new folder, or remove this one')
    names = [name for name, topic in recording.topics.items() if topic.count]
    for name in arguments.topics or ():
        if name not in names:
            raise UnusableInput(f'nothing was published on {name}', help=f'choose topics with messages: {", ".join(names)}')
    chosen = arguments.topics or names
    try:
        if arguments.bag is not None:
            _write_bag(recording, folder, arguments.storage, chosen)
        elif arguments.mcap is not None:
            _write_mcap(recording, folder, chosen)
        else:
            _write_tables(recording, folder, chosen)
    except OSError as error:
        raise UnusableInput(f'cannot write {folder}: {error.strerror}') from None
    print(folder)
    return 0


def _write_bag(recording: Recording, folder: str, storage: str, names: list[str]) -> None:
    """Write a bag in which each message has the time of its publication.

    If a topic has several types, write only the first type.
    """
    from edulaunch.desk.cli.ros2.bag import require_rosbags

    require_rosbags()
    from edulaunch.desk.cli.ros2.bag_write import write_bag

    topics = [
        SimpleNamespace(name=name, cls=type(recording.messages(name)[0][1]), offered=recording.offered(name)) for name in names
    ]
    messages = [
        (recording.start_ns + time_ns, topic.name, wire)
        for topic in topics
        for time_ns, wire in recording.wires(topic.name, topic.cls.TYPE)
    ]
    write_bag(folder, storage, topics, sorted(messages, key=lambda message: message[0]), recording.registry)


def _write_mcap(recording: Recording, path: str, names: list[str]) -> None:
    """Write a single MCAP file with an index. The content does not depend on the name of the file."""
    from tempfile import TemporaryDirectory

    with TemporaryDirectory(dir=os.path.dirname(path) or '.') as place:
        folder = os.path.join(place, 'recording')
        _write_bag(recording, folder, 'mcap', names)
        os.replace(os.path.join(folder, 'recording.mcap'), path)


def _write_tables(recording: Recording, folder: str, names: list[str]) -> None:
    """Write one table for each topic, such as `turtle1.pose.csv` for /turtle1/pose.

    The columns are the time in seconds, and each number or string of the messages.
    """
    import csv

    os.makedirs(folder)
    for name in names:
        rows = [(time_s, dict(_cells(message))) for time_s, message in recording.messages(name)]
        columns = list(dict.fromkeys(column for _, cells in rows for column in cells))
        with open(os.path.join(folder, name.strip('/').replace('/', '.') + '.csv'), 'w', encoding='utf-8', newline='') as file:
            table = csv.writer(file)
            table.writerow(['time', *columns])
            table.writerows([f'{time_s:.9f}', *(cells.get(column, '') for column in columns)] for time_s, cells in rows)


def _cells(value: Any, path: str = '') -> Iterator[tuple[str, Any]]:
    """Yield the path and the value of each number or string in a message, such as ('linear.x', 2.0)."""
    fields = getattr(value, 'get_fields_and_field_types', None)
    if fields is not None:
        for name in fields():
            yield from _cells(getattr(value, name), f'{path}.{name}' if path else name)
    elif hasattr(value, '__iter__') and not isinstance(value, (str, bytes)):
        for number, item in enumerate(value):
            yield from _cells(item, f'{path}.{number}')
    else:
        yield path, value


def show_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options that choose a page or a picture, and its content."""
    _file_arguments(parser)
    parser.add_argument(
        '--html', metavar='OUT', nargs='?', const='', help='write an HTML page that replays the run (default: FILE.html)'
    )
    parser.add_argument('--png', metavar='OUT', nargs='?', const='', help='write a picture (default: FILE.png)')
    parser.add_argument('--what', choices=PICTURES, help='content of the picture (default: turtles, otherwise nodes and topics)')
    parser.add_argument('--at', type=float, metavar='SECONDS', help='time of the picture (default: the end of the run)')
    parser.add_argument('--tab', choices=TABS, default='graph', help='the first tab on the right side of the page')
    parser.add_argument('--with', dest='other', metavar='OTHER', help='a recording that the page plots over this one')
    parser.add_argument('--open', action='store_true', help='open the result in a browser')


def show(arguments: argparse.Namespace) -> int:
    """Write the page or picture, and print its path. Return the exit code 0.

    :raises UnusableInput: when the page or picture cannot be written.
    :raises NothingToDraw: when the recording does not contain what the picture shows.
    """
    recording = Recording.load(arguments.file, trusted=arguments.trusted)
    stem = os.path.splitext(arguments.file)[0]
    written = []
    try:
        if arguments.html is not None or arguments.png is None:
            other = Recording.load(arguments.other, trusted=arguments.trusted) if arguments.other else None
            written.append(write_page(recording, arguments.html or f'{stem}.html', arguments.tab, other))
        if arguments.png is not None:
            written.append(write_picture(recording, arguments.png or f'{stem}.png', arguments.what, arguments.at))
    except OSError as error:
        raise UnusableInput(f'cannot write {error.filename}: {error.strerror}') from None
    for path in written:
        print(path)
    if arguments.open:
        webbrowser.open(f'file://{os.path.abspath(written[0])}')
    return 0


def write_page(recording: Recording, path: str, tab: str = 'graph', other: Recording | None = None) -> str:
    """Write a page that replays a recording in any browser, without a network. Return its path.

    :param path: the path of the new HTML file.
    :param tab: the tab that the page shows first.
    :param other: a second recording to show for comparison, or None.
    """
    from edulaunch.desk.view.page import recorded_page
    from edulaunch.desk.view.replay import timeline_of

    name = os.path.basename(recording.launch.file or '') or 'recording'
    with open(path, 'w', encoding='utf-8') as file:
        file.write(recorded_page(timeline_of(recording, other), name, tab))
    return path


def write_picture(recording: Recording, path: str, what: str | None = None, time_s: float | None = None) -> str:
    """Write a picture of a recording as a PNG file. Return its path.

    :param path: the path of the new file.
    :param what: the content of the picture (default: the turtles, or the nodes and topics if there are no turtles).
    :param time_s: the time in seconds that a picture of turtles or frames shows (default: the end of the run).
    :raises NothingToDraw: when the recording does not contain what the picture shows.
    """
    from edulaunch.engine.recording.absent import NothingToDraw

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


def diff_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the two recordings, and the options for a picture and a page."""
    _file_arguments(parser)
    parser.add_argument('other', metavar='OTHER', help='the recording to compare with')
    parser.add_argument('--png', metavar='OUT', help='write a picture of both graphs with their differences')
    parser.add_argument('--html', metavar='OUT', help='write a page with that picture and the list of differences')


def diff(arguments: argparse.Namespace) -> int:
    """Print the differences between two recordings. Return 0 if there are no differences, otherwise 1.

    :raises UnusableInput: when the picture or page cannot be written.
    """
    from edulaunch.advice.explaining.systems import differences, pictured, run_differences, system_of_run

    paths = arguments.file, arguments.other
    runs = [Recording.load(path, trusted=arguments.trusted) for path in paths]
    before, after = (system_of_run(run, path) for run, path in zip(runs, paths, strict=True))
    found = [f'{one.sign} {one.text}' for one in differences(before, after)] + run_differences(*runs)
    print('\n'.join(found) or 'no difference')
    try:
        if arguments.png:
            pictured(before, after).save(arguments.png)
            print(arguments.png)
        if arguments.html:
            from edulaunch.desk.view.compared import compared_page

            with open(arguments.html, 'w', encoding='utf-8') as file:
                file.write(compared_page(paths[0], paths[1], found, pictured(before, after)))
            print(arguments.html)
    except OSError as error:
        raise UnusableInput(f'cannot write {error.filename}: {error.strerror}') from None
    return 1 if found else 0


def recording_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the sub-verbs of `edulaunch recording`."""
    verbs = parser.add_subparsers(dest='what_to_do', metavar='diff | export | info | show', required=True)
    info = verbs.add_parser('info', help='print a summary of a recording')
    _file_arguments(info)
    info.add_argument('--json', action='store_true', help='as JSON')
    show_arguments(verbs.add_parser('show', help='write a page that replays a recording, or a picture'))
    diff_arguments(verbs.add_parser('diff', help='list the differences between two recordings'))
    export_arguments(verbs.add_parser('export', help='write the messages to a bag, or to tables'))


def recording_verb(arguments: argparse.Namespace) -> int:
    """Print the summary of a recording, or run another sub-verb. Return the exit code."""
    if arguments.what_to_do != 'info':
        return {'show': show, 'export': export, 'diff': diff}[arguments.what_to_do](arguments)
    summary = summarise(Recording.load(arguments.file, trusted=arguments.trusted))
    if arguments.json:
        import json

        print(json.dumps(summary, indent=2))
    else:
        print(
            '\n'.join(lines(summary)).encode(errors='backslashreplace').decode()
        )  # a program may have written part of a character
    return 0


def summarise(recording: Recording) -> dict[str, Any]:
    """Return the summary of a recording as plain data."""
    return {
        'launch_file': recording.launch.file,
        'arguments': recording.launch.arguments,
        'seed': recording.seed,
        'duration_s': recording.duration_s,
        'digest': recording.digest(),
        'processes': [{name: getattr(process, name) for name in PROCESS} for process in recording.processes],
        'nodes': [{'name': node.name, 'process': node.process} for node in recording.nodes],
        'topics': [
            {
                'name': topic.name,
                'type': topic.type,
                'messages': topic.count,
                'publishers': topic.publishers,
                'subscriptions': topic.subscriptions,
            }
            for topic in recording.topics.values()
        ],
        'log_messages': len(recording.logs),
        'not_repeatable': recording.not_repeatable,
        'warnings': recording.warnings,
    }


def lines(summary: dict[str, Any]) -> list[str]:
    """Return the summary as lines of text for people."""
    arguments = ' '.join(f'{name}:={value}' for name, value in summary['arguments'].items())
    text = [
        f'Launch file:  {summary["launch_file"]} {arguments}'.rstrip(),
        f'Duration:     {summary["duration_s"]:.3f} s (seed {summary["seed"]})',
        f'Digest:       {summary["digest"]}',
        f'Log messages: {summary["log_messages"]}',
        *(f'Not repeatable: {why}' for why in summary['not_repeatable']),
        '',
        'Processes:',
    ]
    for process in summary['processes']:
        end = (
            'running at the end'
            if process['ended_s'] is None
            else f'ended at {process["ended_s"]:.3f} s with code {process["returncode"]}'
        )
        place = '' if process['origin'] is None else f'  [{process["origin"][0]}:{process["origin"][1]}]'
        text.append(f'  {process["name"]} (pid {process["pid"]}): {end}{place}')
    text += ['', 'Nodes:', *(f'  {node["name"]} ({node["process"]})' for node in summary['nodes']), '', 'Topics:']
    width = max((len(topic['name']) for topic in summary['topics']), default=0)
    text += [f'  {topic["name"]:<{width}}  {topic["messages"]:>7} messages  {topic["type"]}' for topic in summary['topics']]
    return [*text, *([''] if summary['warnings'] else []), *(f'warning: {line}' for line in summary['warnings'])]
