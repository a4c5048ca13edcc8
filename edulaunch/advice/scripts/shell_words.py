"""Rules about words in a launch file that only a shell interprets. No code of the file is executed."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import Script, keyword_of, name_of_call, walked

SHELL_WORDS = ('&&', '||', '|', '>', '>>', '<', ';', '&', '2>&1')


@rule(
    'launch.shell-word',
    what="launch passes '{word}' to {program} as an argument, but only a shell gives it a special meaning",
    why='launch starts the program without a shell and passes each entry of cmd unchanged',
    do="write the command as one string, and add a shell: cmd=['...'], shell=True",
    lesson='05_events',
    level='error',
    hides=('programs.died',),
)
def shell_word(scripts: list[Script]) -> Iterator[Finding]:
    """Report code such as `ExecuteProcess(cmd=['sleep', '1', '&&', 'ros2', ...])` without `shell=True`."""
    for file, tree in scripts:
        for call in walked(tree):
            if not isinstance(call, ast.Call) or name_of_call(call) not in ('ExecuteProcess', 'ExecuteLocal'):
                continue
            words = keyword_of(call, 'cmd')
            if keyword_of(call, 'shell') is not None or not isinstance(words, ast.List):
                continue
            texts = [word.value for word in words.elts if isinstance(word, ast.Constant)]
            for word in texts[1:]:
                if word in SHELL_WORDS:
                    yield found('file', file, file=file, line=call.lineno, word=word, program=texts[0])
                    break
