"""Reports in several formats: JSON, a terminal, a web page and JUnit XML."""
