"""composition: The composition tutorial: nodes to be loaded into one process."""
