"""Colours of terminals."""

from .impl import remove_ansi_escape_sequences

__all__ = ['remove_ansi_escape_sequences']
