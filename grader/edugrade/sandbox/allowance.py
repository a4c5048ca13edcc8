"""What a run may use besides memory and time, and the name of a layer that not every system has. It imports nothing."""

MOST_PROCESSES = 64
MOST_THREADS = 512
"""Of all its processes together: a computer has a limited number."""
MOST_BYTES, MOST_FILES = 128 << 20, 4096
"""In its own folder."""
VIEW = 'view'
"""A layer of confinement more: a run sees no names and sizes of files that it may not read."""
