"""Finds and loads rubrics in Python and YAML."""
