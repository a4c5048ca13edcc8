"""Each run of a comparison in a folder of its own: it finds what stands in the current one, and nothing that another run left
there (the bag that both record); and nothing is left behind.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from tempfile import TemporaryDirectory
from typing import ParamSpec, TypeVar

Args = ParamSpec('Args')
Result = TypeVar('Result')


def in_isolation(run: Callable[Args, Result], /, *args: Args.args, **kwargs: Args.kwargs) -> Result:
    """Call it in a new folder with links to all that is in the current one and in the folder above; that goes afterwards."""
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
