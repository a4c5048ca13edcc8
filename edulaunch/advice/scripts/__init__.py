"""Rules for the syntax trees of the launch files of a run or of a dry run."""
