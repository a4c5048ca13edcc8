"""Marks in the formats of learning platforms; each file names the document that its format is from."""
