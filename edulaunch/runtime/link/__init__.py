"""One simulation in two operating-system processes: a trusted peer and a confined peer, joined by a socket in lock-step simulated
time.

Read the files in this order:

- `clock`: one agenda in two peers
- `codec`: the frames
- `peer`: the token and calls
- `replica`: the graph in both peers
- `trusted`: worlds, stock nodes and the recorder
- `confined`: launch and the student's nodes
"""
