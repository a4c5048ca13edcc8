"""The program xacro: prints a robot description with its macros filled in; the work is done by the library of that name."""

from __future__ import annotations

import sys

import xacro


def main() -> int:
    """`xacro FILE name:=value ... [-o OUT]`; 2 for a file that it cannot fill in."""
    options, file = xacro.process_args(sys.argv[1:])
    try:
        document = xacro.process_file(file, **vars(options))
        while document.firstChild is not document.documentElement:
            document.removeChild(document.firstChild)  # a comment with the path of the file, which is another on each machine
        text = document.toprettyxml(indent='  ')
    except Exception as error:  # the file may raise anything: its expressions are Python
        print(f'error: {error}\nwhen processing file: {file}', file=sys.stderr)
        return 2
    if options.output is None:
        print(text)
        return 0
    with open(options.output, 'w', encoding='utf-8') as out:
        out.write(text)
    return 0
