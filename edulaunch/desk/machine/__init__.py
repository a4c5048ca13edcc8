"""The shared machine: one simulated computer per user and `ROS_DOMAIN_ID`, with as many terminals as one likes.

A *machine* is a process that hosts one Session in real time. A *terminal* is a thin client: it hands words, folder, environment
and keyboard over, and the command runs inside the machine's simulation. The client side (`command`, `client`, `place`, `wire`)
uses the standard library only and imports nothing of the engine: it starts like a shell command.
"""
