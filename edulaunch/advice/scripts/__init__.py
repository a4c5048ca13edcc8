"""Rules over the launch files of a run or of a dry run, as syntax trees."""
