"""The limits of a run other than memory and time, and the name of a layer that some systems lack.

This module imports nothing.
"""

MOST_PROCESSES = 64
MOST_THREADS = 512
"""The most threads of all its processes together, because a computer has a limited number."""
MOST_BYTES, MOST_FILES = 128 << 20, 4096
"""The maximum size and number of files in the run's own folder."""
VIEW = 'view'
"""An additional layer of confinement: a run sees neither names nor sizes of files that it may not read."""
