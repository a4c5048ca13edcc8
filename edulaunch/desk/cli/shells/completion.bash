# Tab completion for bash: put  eval "$(edulaunch completion bash)"  into ~/.bashrc
_edulaunch() {
    local IFS=$'\n'
    COMPREPLY=($(edulaunch completion bash --line "${COMP_LINE:0:$COMP_POINT}" 2>/dev/null))
    if [ "${#COMPREPLY[@]}" = 1 ]; then
        case "${COMPREPLY[0]}" in *=|*/) compopt -o nospace ;; esac
    fi
}
complete -F _edulaunch edulaunch edugrade
complete -p ros2 > /dev/null 2>&1 || complete -F _edulaunch ros2
