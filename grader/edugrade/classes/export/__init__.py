"""Exports marks in the formats of learning platforms. Each module names the document that describes its format."""
