# Tab completion for zsh: put  eval "$(edulaunch completion zsh)"  into ~/.zshrc, below compinit
_edulaunch() {
    local -a found open
    found=("${(@f)$(edulaunch completion zsh --line "$LBUFFER" 2>/dev/null)}")
    open=(${(M)found:#*[=/]})
    found=(${found:#*[=/]})
    (( $#open )) && compadd -S '' -- $open
    (( $#found )) && compadd -- $found
}
compdef _edulaunch edulaunch edugrade ros2
