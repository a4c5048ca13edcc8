"""composition: The composition tutorial with nodes that can be loaded into one process."""
