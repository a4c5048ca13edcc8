"""All tests see the underlay, as after `edulaunch.source()`."""
from __future__ import annotations

import edulaunch

edulaunch.source()
