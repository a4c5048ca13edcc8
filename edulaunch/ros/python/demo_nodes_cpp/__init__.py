"""demo_nodes_cpp: small programs for first steps, which behave like the C++ originals."""
