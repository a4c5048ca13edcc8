"""The shared machine: one simulated machine for each user and `ROS_DOMAIN_ID`, with any number of terminals.

A *machine* is a process that hosts one Session in real time. A *terminal* is a small client, which sends its command, folder,
environment and keyboard input. The command runs inside the machine's simulation. The client modules (`command`, `client`,
`place`, `wire`) import only the standard library, so that they start as fast as a shell command.
"""
