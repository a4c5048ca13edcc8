"""demo_nodes_cpp: small programs for first steps, seen from outside as the C++ originals are."""
