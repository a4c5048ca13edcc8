# Functions for bash and zsh that explain a tutorial's set-up commands. They run the real program for anything else.
colcon() {
    if (unset -f colcon; command -v colcon) > /dev/null 2>&1; then command colcon "$@"; else edulaunch colcon "$@"; fi
}
sudo() { edulaunch env --answer "$@" || command sudo "$@"; }
apt() { edulaunch env --answer apt "$@" || command apt "$@"; }
function source {
    if [ -e "$1" ] || ! edulaunch env --answer source "$1"; then builtin source "$@"; fi
}
function . { source "$@"; }
function ls {
    command ls "$@" && return
    local code=$?
    case "$*" in *install*|*build*|*.ros/log*) edulaunch env --answer ls "$@" ;; esac
    return $code
}
for name in @WINDOWS@; do
    command -v $name > /dev/null 2>&1 || eval "$name() { edulaunch env --answer $name; }"
done
unset name
