"""Decoys of a solution: submissions with the names of the solution, but without its behaviour. A rubric that gives points for a
decoy checks only names.
"""
