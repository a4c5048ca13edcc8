"""Rules that explain the error which ended a program, a launch or a command (`Failure`)."""
