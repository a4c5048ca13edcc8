# Written by `edulaunch env --install` for bash and zsh. bin/activate reads this file; `deactivate` undoes its effects.
_edulaunch_without() {  # prints the list of paths $1 without the path $2
    local paths=":$1:"
    paths=${paths//":$2:"/:}
    paths=${paths#:}
    printf '%s' "${paths%:}"
}
_edulaunch_off() {
    local name
    if [ -n "${_EDULAUNCH_SOURCED:-}" ]; then
        PYTHONPATH=$(_edulaunch_without "${PYTHONPATH:-}" @SHELL@)
        PYTHONPATH=$(_edulaunch_without "$PYTHONPATH" @PYTHON@)
        AMENT_PREFIX_PATH=$(_edulaunch_without "${AMENT_PREFIX_PATH:-}" @PREFIX@)
        [ -n "$PYTHONPATH" ] || unset PYTHONPATH
        [ -n "$AMENT_PREFIX_PATH" ] || unset AMENT_PREFIX_PATH
        unset ROS_DISTRO ROS_VERSION ROS_PYTHON_VERSION _EDULAUNCH_SOURCED
    fi
    if [ -n "${_EDULAUNCH_COMPLETES:-}" ]; then
        if [ -n "${ZSH_VERSION:-}" ]; then compdef -d edulaunch edugrade ros2; else complete -r edulaunch edugrade ros2; fi
        unset _EDULAUNCH_COMPLETES
    fi 2> /dev/null || :
    for name in @NAMES@; do
        case "$(typeset -f "$name" 2> /dev/null)" in *edulaunch*|*'source "$@"'*) unset -f "$name" ;; esac
    done
}
case ":${AMENT_PREFIX_PATH:-}:" in
::|*:@PREFIX@:*)  # no real ROS 2 is sourced in this shell
    _EDULAUNCH_SOURCED=1
    case ":${PYTHONPATH:-}:" in
    *:@PYTHON@:*) ;;
    *) export PYTHONPATH=@SHELL@:@PYTHON@"${PYTHONPATH:+:$PYTHONPATH}" ;;
    esac
    export AMENT_PREFIX_PATH="${AMENT_PREFIX_PATH:-@PREFIX@}" ROS_DISTRO=jazzy ROS_VERSION=2 ROS_PYTHON_VERSION=3
    ;;
esac
case $- in *i*)
    if [ -n "${ZSH_VERSION:-}" ]; then
        command -v compdef > /dev/null || { autoload -Uz compinit && compinit -i; }
        eval @ZSH@
    else
        eval @BASH@
    fi
    _EDULAUNCH_COMPLETES=1
    ;;
esac
eval "_edulaunch_venv_$(typeset -f deactivate)"
deactivate() {
    if [ "${1:-}" != nondestructive ]; then
        _edulaunch_off
        unset -f _edulaunch _edulaunch_off _edulaunch_without
    fi 2> /dev/null
    _edulaunch_venv_deactivate "$@"
    [ "${1:-}" = nondestructive ] || unset -f deactivate _edulaunch_venv_deactivate 2> /dev/null || :
}
eval @FUNCTIONS@
