"""Rules for a whole workspace (`Workspace`). No code of the workspace is executed."""
