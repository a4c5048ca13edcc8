# Tab completion for fish: put  edulaunch completion fish | source  into ~/.config/fish/config.fish
function __edulaunch
    edulaunch completion fish --line (commandline --cut-at-cursor | string collect) 2>/dev/null
end
complete -c edulaunch -f -a '(__edulaunch)'
complete -c edugrade -f -a '(__edulaunch)'
complete -c ros2 -f -a '(__edulaunch)'
