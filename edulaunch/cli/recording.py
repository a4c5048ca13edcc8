"""`edulaunch recording info|show|export`: what a recording holds, as text, pictures and other files."""

from __future__ import annotations

import argparse
from typing import Any

from edulaunch.cli import recording_export, recording_show
from edulaunch.recording import Recording


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The sub-verbs."""
    verbs = parser.add_subparsers(dest='what_to_do', metavar='export | info | show', required=True)
    info = verbs.add_parser('info', help='say what a recording holds')
    info.add_argument('file', metavar='FILE', help='a recording')
    info.add_argument('--json', action='store_true', help='as JSON')
    recording_show.add_arguments(verbs.add_parser('show', help='write a page that plays a recording, or a picture'))
    recording_export.add_arguments(verbs.add_parser('export', help='write the messages as a bag, or as tables'))


def main(arguments: argparse.Namespace) -> int:
    """Print the summary, or write a page, a picture, a bag or tables; returns the exit code."""
    if arguments.what_to_do != 'info':
        return (recording_show.show if arguments.what_to_do == 'show' else recording_export.export)(arguments)
    summary = summarise(Recording.load(arguments.file))
    if arguments.json:
        import json

        print(json.dumps(summary, indent=2))
    else:
        print('\n'.join(lines(summary)).encode(errors='backslashreplace').decode())  # a program may have written half a letter
    return 0


def summarise(recording: Recording) -> dict[str, Any]:
    """The summary as plain data."""
    return {
        'launch_file': recording.launch.file,
        'arguments': recording.launch.arguments,
        'seed': recording.seed,
        'duration_s': recording.duration_s,
        'digest': recording.digest(),
        'processes': [
            {
                'name': process.name,
                'pid': process.pid,
                'origin': process.origin,
                'started_s': process.started_s,
                'ended_s': process.ended_s,
                'returncode': process.returncode,
            }
            for process in recording.processes
        ],
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
    """The summary for people."""
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
