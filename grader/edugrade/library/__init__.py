"""What rubrics share: finding processes and topics in a recording, and measuring movements.

`launched.py` finds what was started, `movement.py` measures tracks, `circle_fit.py` fits a circle.
"""
