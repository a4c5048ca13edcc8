"""part3_beyond_basics: what readers of the course build; here so that its launch files can be tried first."""
