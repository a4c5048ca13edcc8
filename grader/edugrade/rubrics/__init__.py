"""Rubrics: where they are found, and those that are written in YAML."""
