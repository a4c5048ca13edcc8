"""Rules over a whole workspace (`Workspace`). None of its code is executed."""
