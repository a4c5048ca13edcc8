"""What this plug-in adds to edulaunch."""

import os

from edulaunch.runtime.plugins import Plugin, Verb

PLUGIN = Plugin(
    verbs={'ferry': Verb('Let the ferry cross the river', 'ferry.verb')},
    rules={'recordings': 'ferry.rules'},
    packages=(os.path.join(os.path.dirname(__file__), 'packages'),),
)
