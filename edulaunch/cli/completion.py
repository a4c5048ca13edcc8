"""`edulaunch completion bash|zsh`: the script that lets a shell complete our commands with the Tab key."""

from __future__ import annotations

import argparse

SCRIPTS = {
    'bash': """# Tab completion of edulaunch for bash: put  eval "$(edulaunch completion bash)"  into ~/.bashrc
_edulaunch() {
    local IFS=$'\\n'
    COMPREPLY=($(edulaunch completion bash --line "${COMP_LINE:0:$COMP_POINT}" 2>/dev/null))
    if [ "${#COMPREPLY[@]}" = 1 ]; then
        case "${COMPREPLY[0]}" in *=|*/) compopt -o nospace ;; esac
    fi
}
complete -F _edulaunch edulaunch
""",
    'zsh': """# Tab completion of edulaunch for zsh: put  eval "$(edulaunch completion zsh)"  into ~/.zshrc, below compinit
_edulaunch() {
    local -a found open
    found=("${(@f)$(edulaunch completion zsh --line "$LBUFFER" 2>/dev/null)}")
    open=(${(M)found:#*[=/]})
    found=(${found:#*[=/]})
    (( $#open )) && compadd -S '' -- $open
    (( $#found )) && compadd -- $found
}
compdef _edulaunch edulaunch
""",
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The shell; and what the script asks for."""
    parser.add_argument('shell', choices=sorted(SCRIPTS), help='print the script for this shell')
    parser.add_argument('--line', metavar='TEXT', help='print what could stand at the end of this line (the script asks so)')


def main(arguments: argparse.Namespace) -> int:
    """Print the script, or the candidates, one on a line."""
    if arguments.line is None:
        print(SCRIPTS[arguments.shell], end='')
        return 0
    from edulaunch.cli.candidates import candidates

    for candidate in candidates(arguments.line, break_words=arguments.shell == 'bash'):
        print(candidate)
    return 0
