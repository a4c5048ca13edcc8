"""logging_demo: Log calls of different kinds, and levels that change while the program runs."""
