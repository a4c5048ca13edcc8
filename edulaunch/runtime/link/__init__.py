"""One simulation in two processes: a trusted peer and a confined one, joined by a socket in lock-step simulated time.

Read in this order: `clock` (one agenda in two peers), `codec` (what a frame is), `peer` (the token, calls), `replica` (the
graph in both), then `trusted` (worlds, stock nodes, recorder) and `confined` (launch, the student's nodes).
"""
