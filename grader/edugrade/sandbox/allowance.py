"""The limits of a run on processes, threads and files, and the name of a layer of the sandbox that some systems do not support.

This module imports nothing.
"""

MOST_PROCESSES = 64
MOST_THREADS = 512
"""The most threads of all its processes together, because a computer has a limited number."""
MOST_BYTES, MOST_FILES, MOST_BYTES_OF_FILE = 128 << 20, 4096, 64 << 20
"""The maximum size and number of files in the run's own folder, and the maximum size of one file."""
VIEW = 'view'
"""An additional layer of confinement: a run sees neither names nor sizes of files that it may not read."""
