"""Run each part of a comparison in a separate folder, with access to the current folder but not to files of other runs.

For example, the simulation and the real run may both record a bag. Each folder is deleted afterwards.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from tempfile import TemporaryDirectory
from typing import ParamSpec, TypeVar

Args = ParamSpec('Args')
Result = TypeVar('Result')


def in_isolation(run: Callable[Args, Result], /, *args: Args.args, **kwargs: Args.kwargs) -> Result:
    """Call a function in a new folder with links to the contents of the current and the parent folder. Delete the folder
    afterwards.
    """
    here = os.getcwd()
    with TemporaryDirectory(prefix='edulaunch-compare-') as above:
        place = os.path.join(above, os.path.basename(here) or 'root')
        os.mkdir(place)
        for source, target in ((os.path.dirname(here), above), (here, place)):
            for name in os.listdir(source):
                if not os.path.lexists(os.path.join(target, name)):
                    os.symlink(os.path.join(source, name), os.path.join(target, name))
        os.chdir(place)
        try:
            return run(*args, **kwargs)
        finally:
            os.chdir(here)
