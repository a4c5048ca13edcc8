"""A workspace around the folder in which the terminals of a test are."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

SETUP = """from setuptools import setup
setup(name='mine', version='0.0.1', packages=['mine'], data_files=[('share/ament_index/resource_index/packages', ['resource/mine']),
      ('share/mine', ['package.xml'])], entry_points={{'console_scripts': [{}]}})
"""
MANIFEST = '<package format="3"><name>mine</name><version>0.0.1</version><export><build_type>ament_python</build_type></export></package>'


def make_package(folder: Path, programs: Mapping[str, str]) -> Path:
    """A package `mine` with an executable for each module text; returns its folder."""
    place = folder / 'src' / 'mine'
    files = {
        'package.xml': MANIFEST,
        'setup.py': SETUP.format(', '.join(f"'{name} = mine.{name}:main'" for name in programs)),
        'setup.cfg': '[develop]\nscript_dir=$base/lib/mine\n[install]\ninstall_scripts=$base/lib/mine\n',
        'resource/mine': '',
        'mine/__init__.py': '',
        **{f'mine/{name}.py': text for name, text in programs.items()},
    }
    for name, text in files.items():
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_text(text)
    return place
