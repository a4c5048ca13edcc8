"""lifecycle_py: A lifecycle node that publishes."""
