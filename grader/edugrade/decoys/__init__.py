"""Decoys of a solution: submissions with its names but without its behaviour. A rubric that gives points for a decoy checks
only names.
"""
