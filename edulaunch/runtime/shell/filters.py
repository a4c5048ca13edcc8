"""Programs after a `|`. Each line is passed on when it arrives, so the output of an endless program appears, too."""

from __future__ import annotations

import getopt
import re
import subprocess
from collections.abc import Callable, Mapping, Sequence
from itertools import groupby
from typing import Any, Protocol

Lines = tuple[Callable[[str], object], Callable[[], object]]
"""The handler of each line, and the function to call at the end."""
Stop = Callable[[], object]
LONGEST_S = 10.0
"""A real program has this many real seconds to process its input."""


class Sink(Protocol):
    """A destination of output."""

    def write(self, text: str) -> object:
        """Filter the text."""

    def close(self) -> object:
        """Handle the end of the input."""


class Filter:
    """Passes lines on through one of :data:`FILTERS`.

    :param stop: a function that is called when no more input is needed.
    :ivar returncode: the exit code so far.
    """

    def __init__(self, words: Sequence[str], sink: Sink, stop: Stop) -> None:
        self.returncode = 0
        self._sink = sink
        self._rest = ''
        self._stop = stop
        self._take, self._end = FILTERS[words[0]](self, words[1:])

    def say(self, line: str) -> None:
        """Pass a line on."""
        self._sink.write(line + '\n')

    def say_all(self, lines: Sequence[str]) -> None:
        """Pass lines on."""
        for line in lines:
            self.say(line)

    def enough(self) -> None:
        """Stop reading lines."""
        self._take = lambda line: None
        self._stop()

    def write(self, text: str) -> None:
        """Filter the text. An incomplete line is stored until the rest of it arrives."""
        *lines, self._rest = (self._rest + text).split('\n')
        for line in lines:
            self._take(line)

    def close(self) -> None:
        """Filter the last line, and end the output."""
        if self._rest:
            self._take(self._rest)
        self._end()
        self._sink.close()


class RealFilter:
    """Any other program. It receives the whole input when the input ends."""

    def __init__(self, words: Sequence[str], sink: Sink, cwd: str | None, env: Mapping[str, str]) -> None:
        self.returncode = 0
        self._text = ''
        self._run: dict[str, Any] = {'args': list(words), 'cwd': cwd, 'env': dict(env), 'timeout': LONGEST_S}
        self._sink = sink

    def write(self, text: str) -> None:
        """Store the text."""
        self._text += text

    def close(self) -> None:
        """Run the program."""
        try:
            done = subprocess.run(input=self._text, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **self._run)
            self.returncode = done.returncode
            self._sink.write(done.stdout)
        except FileNotFoundError:
            self.returncode = 127
            self._sink.write(f'sh: {self._run["args"][0]}: not found\n')
        self._sink.close()


def is_filter(words: Sequence[str]) -> bool:
    """Return whether :class:`Filter` supports the command. A filter supports common options, and reads no files."""
    try:
        return words[0] in FILTERS and _options(words[0], words[1:]) is not None
    except (getopt.GetoptError, ValueError):
        return False


_KNOWN = {'grep': ('ivcnoEFwe:', 1), 'head': ('n:', 0), 'tail': ('n:', 0), 'wc': ('lwc', 0), 'sort': ('rnu', 0), 'uniq': ('c', 0)}


def _options(name: str, words: Sequence[str]) -> tuple[dict[str, str], list[str]] | None:
    """Return the options and the other words. Return None if there are too many other words."""
    letters, most = _KNOWN.get(name, ('', 0))
    words = [f'-n{word[1:]}' if re.fullmatch(r'-\d+', word) else word for word in words]
    options, others = getopt.gnu_getopt(words, letters)
    if len(others) > most:
        return None
    return dict(options), others


def _grep(filter: Filter, words: Sequence[str]) -> Lines:
    options, others = _options('grep', words) or ({}, [])
    text = options.get('-e') or others[0]
    text = re.escape(text) if '-F' in options else text
    text = rf'\b(?:{text})\b' if '-w' in options else text.replace(r'\|', '|')
    pattern = re.compile(text, re.IGNORECASE if '-i' in options else 0)
    count = number = 0
    filter.returncode = 1

    def take(line: str) -> None:
        nonlocal count, number
        number += 1
        if bool(found := pattern.search(line)) == ('-v' in options):
            return
        count += 1
        filter.returncode = 0
        if '-c' not in options:
            shown = found[0] if found and '-o' in options else line
            filter.say(f'{number}:{shown}' if '-n' in options else shown)

    return take, lambda: filter.say(str(count)) if '-c' in options else None


def _head(filter: Filter, words: Sequence[str]) -> Lines:
    left = int((_options('head', words) or ({}, []))[0].get('-n', '10'))

    def take(line: str) -> None:
        nonlocal left
        left -= 1
        if left >= 0:
            filter.say(line)
        if left <= 0:
            filter.enough()

    return take, lambda: None


def _collected(change: Callable[[list[str], dict[str, str]], list[str]], name: str) -> Callable[[Filter, Sequence[str]], Lines]:
    """Return a filter that has no output before its input ends."""

    def make(filter: Filter, words: Sequence[str]) -> Lines:
        lines: list[str] = []
        options = (_options(name, words) or ({}, []))[0]
        return lines.append, lambda: filter.say_all(change(lines, options))

    return make


def _tail(lines: list[str], options: dict[str, str]) -> list[str]:
    return lines[-int(options.get('-n', '10')) :]


def _wc(lines: list[str], options: dict[str, str]) -> list[str]:
    words, letters = sum(len(line.split()) for line in lines), sum(len(line.encode()) + 1 for line in lines)
    chosen = [str(value) for key, value in (('-l', len(lines)), ('-w', words), ('-c', letters)) if not options or key in options]
    return [' '.join(chosen)]


def _sort(lines: list[str], options: dict[str, str]) -> list[str]:
    def number(line: str) -> float:
        found = re.match(r'\s*(-?[\d.]+)', line)
        return float(found[1]) if found else 0.0

    found = sorted(sorted(set(lines) if '-u' in options else lines), key=number if '-n' in options else None)
    return found[::-1] if '-r' in options else found


def _uniq(lines: list[str], options: dict[str, str]) -> list[str]:
    groups = [(line, len(list(same))) for line, same in groupby(lines)]
    return [f'{count:7} {line}' if '-c' in options else line for line, count in groups]


def _cat(filter: Filter, words: Sequence[str]) -> Lines:
    return filter.say, lambda: None


FILTERS: dict[str, Callable[[Filter, Sequence[str]], Lines]] = {
    'cat': _cat,
    'grep': _grep,
    'head': _head,
    'sort': _collected(_sort, 'sort'),
    'tail': _collected(_tail, 'tail'),
    'uniq': _collected(_uniq, 'uniq'),
    'wc': _collected(_wc, 'wc'),
}
