"""What the grader adds to edulaunch: `edulaunch.check`."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin

PLUGIN = Plugin(functions={'check': 'edugrade.notebook:check'})
