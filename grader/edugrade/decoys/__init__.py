"""Decoys of a solution: submissions that keep its names and drop its behaviour. A rubric that pays for them looks at names."""
