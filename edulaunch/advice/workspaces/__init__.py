"""Rules over a workspace as a whole (`Workspace`); nothing of it is executed."""
