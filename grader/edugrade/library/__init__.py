"""Functions that rubrics share. They find processes and topics in a recording, and measure movements.

`launched.py` finds the programs that were started, `identity.py` finds out which programs they really are, and `movement.py`
measures tracks.
"""
