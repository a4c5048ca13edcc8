"""What rubrics share: finding processes and topics in a recording, and measuring movements.

`launched.py` finds what was started, `stock.py` says whether it is what it is called, `movement.py` measures tracks.
"""
