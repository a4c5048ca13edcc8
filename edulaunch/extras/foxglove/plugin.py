"""The plug-in for Foxglove, which adds `edulaunch view --foxglove`, `.foxglove()` in notebooks, and a service of the machine."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin

PLUGIN = Plugin(
    options={'view': 'edulaunch.extras.foxglove.options'},
    services={'foxglove': 'edulaunch.extras.foxglove.service'},
    functions={'foxglove': 'edulaunch.extras.foxglove.notebook:foxglove'},
)
