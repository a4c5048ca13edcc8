"""Rules that explain the error (`Failure`) that ended a program, a launch or a command."""
