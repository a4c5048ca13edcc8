"""part3_beyond_basics: The package that readers of the course build, included so that they can first try its launch files."""
