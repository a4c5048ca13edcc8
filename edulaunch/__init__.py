"""edulaunch: learn ROS 2 launch, tf2 and turtlesim without ROS.

The package runs unmodified launch files and rclpy packages in a deterministic simulation::

    import edulaunch
    recording = edulaunch.run('solutions/circle.launch.py', arguments={'circle_radius': '1.0'}, duration_s=20)
    recording.plot_turtles()

`import edulaunch` loads no other module and changes nothing. Each public name is loaded when it is first used.
"""

from edulaunch.desk.facade import TYPE_CHECKING
from edulaunch.desk.facade import __all__ as __all__
from edulaunch.desk.facade import __dir__ as __dir__
from edulaunch.desk.facade import __getattr__ as __getattr__

if TYPE_CHECKING:
    from edulaunch.advice.explaining import explain as explain
    from edulaunch.desk.machine.started import start as start
    from edulaunch.desk.notebook import load_ipython_extension as load_ipython_extension
    from edulaunch.desk.notebook.checking import check as check
    from edulaunch.desk.notebook.interact import interact as interact
    from edulaunch.engine.recording import Recording as Recording
    from edulaunch.errors import EdulaunchError as EdulaunchError
    from edulaunch.errors import LaunchFileError as LaunchFileError
    from edulaunch.errors import UnusableInput as UnusableInput
    from edulaunch.ros.sourcing import source as source
    from edulaunch.runtime.session import Session as Session
    from edulaunch.runtime.session import run as run
    from edulaunch.runtime.version import __version__ as __version__
