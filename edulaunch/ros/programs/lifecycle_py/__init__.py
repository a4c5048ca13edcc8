"""lifecycle_py: A node with a lifecycle."""
