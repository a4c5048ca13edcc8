# Written by `edulaunch env --install` for fish. bin/activate.fish reads this file; `deactivate` undoes its effects.
if test -z "$AMENT_PREFIX_PATH"; or contains -- @PREFIX@ (string split : -- "$AMENT_PREFIX_PATH")
    set -g _edulaunch_sourced 1
    set -l paths (string split -n : -- "$PYTHONPATH")
    contains -- @PYTHON@ $paths; or set -gx PYTHONPATH (string join : -- @SHELL@ @PYTHON@ $paths)
    test -n "$AMENT_PREFIX_PATH"; or set -gx AMENT_PREFIX_PATH @PREFIX@
    set -gx ROS_DISTRO jazzy
    set -gx ROS_VERSION 2
    set -gx ROS_PYTHON_VERSION 3
end
@FISH@
set -g _edulaunch_functions source .
function source
    if test -z "$argv[1]"; or test "$argv[1]" = -; or test -e "$argv[1]"; or not edulaunch env --answer source $argv[1]
        builtin source $argv
    end
end
function .
    source $argv
end
function sudo
    edulaunch env --answer $argv; or command sudo $argv
end
function apt
    edulaunch env --answer apt $argv; or command apt $argv
end
function ls
    command ls $argv; and return
    set -l code $status
    string match -qr 'install|build|\.ros/log' -- "$argv"; and edulaunch env --answer ls $argv
    return $code
end
set -a _edulaunch_functions sudo apt ls
if not command -q colcon
    function colcon
        edulaunch colcon $argv
    end
    set -a _edulaunch_functions colcon
end
for name in @WINDOWS@
    if not command -q $name
        eval "function $name; edulaunch env --answer $name; end"
        set -a _edulaunch_functions $name
    end
end
functions -e _edulaunch_venv_deactivate
functions -c deactivate _edulaunch_venv_deactivate
function deactivate
    if test "$argv[1]" != nondestructive
        functions -e $_edulaunch_functions
        complete -e -c edulaunch
        complete -e -c edugrade
        complete -e -c ros2
        if set -q _edulaunch_sourced
            set -l paths (string split -n : -- "$PYTHONPATH" | string match -v -- @SHELL@ | string match -v -- @PYTHON@)
            set -gx PYTHONPATH (string join : -- $paths)
            test -n "$PYTHONPATH"; or set -e PYTHONPATH
            set -gx AMENT_PREFIX_PATH (string join : -- (string match -v -- @PREFIX@ (string split -n : -- "$AMENT_PREFIX_PATH")))
            test -n "$AMENT_PREFIX_PATH"; or set -e AMENT_PREFIX_PATH
            set -e ROS_DISTRO ROS_VERSION ROS_PYTHON_VERSION _edulaunch_sourced
        end
        set -e _edulaunch_functions
    end
    _edulaunch_venv_deactivate $argv
    if test "$argv[1]" != nondestructive
        functions -e _edulaunch_venv_deactivate __edulaunch deactivate
    end
end
