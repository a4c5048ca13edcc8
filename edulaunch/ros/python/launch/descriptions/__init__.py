"""Descriptions of programs."""

from .executable import Executable

__all__ = ['Executable']
