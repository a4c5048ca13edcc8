"""The example programs of launch_testing: what launch tests are tried on."""

from __future__ import annotations

import sys
import time
from contextlib import suppress

LOOPS = 10


def good_proc() -> None:
    """Count aloud, a loop each second, until SIGINT; then end well."""
    print('Starting Up')
    _tell_arguments()
    with suppress(KeyboardInterrupt):
        for loop in range(LOOPS):
            print(f'Loop {loop}')
            time.sleep(1.0)
    print('Shutting Down')


def terminating_proc() -> None:
    """Be ready for a second, and end; with the argument --exception by an error."""
    print('Starting Up')
    _tell_arguments()
    if '--exception' in sys.argv[1:]:
        raise Exception('Process had a pretend error')
    print('Ready')
    with suppress(KeyboardInterrupt):
        time.sleep(1.0)
    print('Shutting Down')


def exit_code_proc() -> int:
    """End with the exit code given by --exit-code N (0), telling so unless --silent."""
    words = sys.argv[1:]
    code = int(words[words.index('--exit-code') + 1]) if '--exit-code' in words else 0
    if '--silent' not in words:
        print(f'Exiting with a code {code}', file=sys.stderr)
    return code


def _tell_arguments() -> None:
    if len(sys.argv) > 1:
        print(f'Called with arguments {sys.argv[1:]}')
