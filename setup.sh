#!/bin/sh
# Sets up .venv once and runs a command in it:  sh setup.sh [--dev] COMMAND [ARGUMENTS]
# --dev also installs what the tests need. Works where pip refuses to install outside a virtual environment.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
venv="${EDULAUNCH_VENV:-$here/.venv}"
what='.[notebook]'
if [ "${1:-}" = "--dev" ]; then
    what='.[dev]'
    shift
fi
[ $# -gt 0 ] || { echo "usage: sh setup.sh [--dev] COMMAND [ARGUMENTS]" >&2; exit 2; }

find_python() {
    for name in python3 python3.14 python3.13 python3.12 python3.11 python3.10 python; do
        if "$name" -c 'import sys; sys.exit(sys.version_info < (3, 10))' 2>/dev/null; then
            echo "$name"
            return
        fi
    done
    echo "edulaunch needs Python 3.10 or newer, and none was found." >&2
    exit 2
}

make_venv() {
    python=$(find_python)
    "$python" -m venv "$venv" >/dev/null 2>&1 && return
    rm -rf "$venv"
    # Debian and Ubuntu keep venv's own pip in a package of its own.
    if command -v apt-get >/dev/null; then
        echo "installing python3-venv (your system asks for it)" >&2
        version=$("$python" -c 'import sys; print("python3.%d-venv" % sys.version_info[1])')
        if [ "$(id -u)" = 0 ]; then as_root=''; else as_root='sudo'; fi
        $as_root apt-get -qq update && { $as_root apt-get -qq install -y "$version" || $as_root apt-get -qq install -y python3-venv; } >/dev/null
    fi
    "$python" -m venv "$venv"
}

stamp="$venv/edulaunch-$what-$(cat "$here/pyproject.toml" "$here/constraints.txt" | cksum | cut -d' ' -f1)"
if [ ! -e "$stamp" ]; then
    [ -x "$venv/bin/python" ] || make_venv
    echo "setting up $venv (once; about a minute)" >&2
    cd "$here"
    "$venv/bin/python" -m pip --disable-pip-version-check install --quiet -c constraints.txt -e "$what"
    cd - >/dev/null
    "$venv/bin/edulaunch" env --install >/dev/null  # `source .venv/bin/activate` brings completion and ROS's packages, too
    # JupyterLab would ask the network for a newer version of itself, and the student about news.
    mkdir -p "$venv/share/jupyter/lab/settings"
    echo '{"@jupyterlab/apputils-extension:notification": {"fetchNews": "false", "checkForUpdates": false}}' \
        > "$venv/share/jupyter/lab/settings/overrides.json"
    touch "$stamp"
fi
PATH="$venv/bin:$PATH"
export PATH
exec "$@"
