"""Functions that rubrics share: they find processes and topics in a recording, and measure movements.

`launched.py` finds the started programs, `identity.py` finds out which programs they really are, and `movement.py` measures
tracks.
"""
