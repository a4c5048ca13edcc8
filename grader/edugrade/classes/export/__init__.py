"""Marks in the formats of learning platforms; each file names the document that describes its format."""
