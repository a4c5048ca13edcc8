"""Rules over errors that ended a program, a launch or a command (`Failure`)."""
