"""The shared machine: one simulated machine per user and `ROS_DOMAIN_ID`, with any number of terminals.

A *machine* is a process that hosts one Session in real time. A *terminal* is a thin client: it passes on words, folder,
environment and keyboard, and the command runs inside the machine's simulation. The client side (`command`, `client`, `place`,
`wire`) imports only the standard library, so that it starts as fast as a shell command.
"""
