"""Finds rubrics, and reads rubrics in YAML."""
