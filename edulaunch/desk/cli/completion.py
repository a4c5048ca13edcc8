"""`edulaunch completion bash|zsh|fish`: the script that lets a shell complete `edulaunch` and `ros2` with the Tab key."""

from __future__ import annotations

import argparse

SCRIPTS = {
    'bash': """# Tab completion for bash: put  eval "$(edulaunch completion bash)"  into ~/.bashrc
_edulaunch() {
    local IFS=$'\\n'
    COMPREPLY=($(edulaunch completion bash --line "${COMP_LINE:0:$COMP_POINT}" 2>/dev/null))
    if [ "${#COMPREPLY[@]}" = 1 ]; then
        case "${COMPREPLY[0]}" in *=|*/) compopt -o nospace ;; esac
    fi
}
complete -F _edulaunch edulaunch
complete -p ros2 > /dev/null 2>&1 || complete -F _edulaunch ros2
""",
    'fish': """# Tab completion for fish: put  edulaunch completion fish | source  into ~/.config/fish/config.fish
function __edulaunch
    edulaunch completion fish --line (commandline --cut-at-cursor | string collect) 2>/dev/null
end
complete -c edulaunch -f -a '(__edulaunch)'
complete -c ros2 -f -a '(__edulaunch)'
""",
    'zsh': """# Tab completion for zsh: put  eval "$(edulaunch completion zsh)"  into ~/.zshrc, below compinit
_edulaunch() {
    local -a found open
    found=("${(@f)$(edulaunch completion zsh --line "$LBUFFER" 2>/dev/null)}")
    open=(${(M)found:#*[=/]})
    found=(${found:#*[=/]})
    (( $#open )) && compadd -S '' -- $open
    (( $#found )) && compadd -- $found
}
compdef _edulaunch edulaunch ros2
""",
}


def completion_arguments(parser: argparse.ArgumentParser) -> None:
    """The shell; and what the script asks for."""
    parser.add_argument('shell', choices=sorted(SCRIPTS), help='print the script for this shell')
    parser.add_argument('--line', metavar='TEXT', help='print what could stand at the end of this line (the script asks so)')


def completion_verb(arguments: argparse.Namespace) -> int:
    """Print the script, or the candidates, one on a line."""
    if arguments.line is None:
        print(SCRIPTS[arguments.shell], end='')
        return 0
    from edulaunch.desk.cli.candidates import candidates

    for candidate in candidates(arguments.line, break_words=arguments.shell == 'bash'):
        print(candidate)
    return 0
