"""Reports as JSON, for a terminal, as a web page and as JUnit XML."""
