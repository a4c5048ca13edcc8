"""A page as PDF, by a headless Chromium that is on the computer already."""

from __future__ import annotations

import os
from pathlib import Path
from shutil import which
from subprocess import TimeoutExpired, run
from tempfile import TemporaryDirectory

BROWSERS = ('chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome', 'msedge')
WAIT_S = 300.0


def write_pdf(page: str, pdf: str) -> str:
    """Print an HTML file, with its headings as an outline and its structure kept for screen readers.

    Returns why there is none, and what to do instead; nothing when it is written.
    """
    browser = next(filter(None, map(which, BROWSERS)), None)
    instead = f'open {page} in a browser and print it into a file'
    if browser is None:
        return f'no PDF: there is no Chromium here ({", ".join(BROWSERS[:3])}); {instead}'
    with TemporaryDirectory(prefix='edulaunch-pdf-', ignore_cleanup_errors=True) as profile:
        words = ['--headless', '--disable-gpu', '--no-pdf-header-footer', '--generate-pdf-document-outline']
        words += ['--no-sandbox'] if hasattr(os, 'geteuid') and os.geteuid() == 0 else []  # as root it has none
        words += [f'--user-data-dir={profile}', f'--print-to-pdf={os.path.abspath(pdf)}', Path(page).resolve().as_uri()]
        try:
            done = run([browser, *words], capture_output=True, text=True, errors='replace', timeout=WAIT_S)
        except (OSError, TimeoutExpired) as error:
            return f'no PDF: {browser} failed: {error}; {instead}'
    return '' if os.path.isfile(pdf) else f'no PDF: {browser} failed: {done.stderr[-300:].strip()}; {instead}'
