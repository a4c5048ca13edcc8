"""A world with a ferry, and what edulaunch says of it: an example of a plug-in."""
