"""The license identifiers that `ros2 pkg create` knows, and the notice that a new package gets."""

from __future__ import annotations

NAMES = {
    'Apache-2.0': 'Apache License 2.0',
    'BSL-1.0': 'Boost Software License 1.0',
    'BSD-2.0': 'BSD 3-Clause "New" or "Revised" License',
    'BSD-2-Clause': 'BSD 2-Clause "Simplified" License',
    'BSD-3-Clause': 'BSD 3-Clause "New" or "Revised" License',
    'GPL-3.0-only': 'GNU General Public License v3.0 only',
    'LGPL-3.0-only': 'GNU Lesser General Public License v3.0 only',
    'MIT': 'MIT License',
    'MIT-0': 'MIT No Attribution',
}
KNOWN = tuple(NAMES)
SPDX = {'BSD-2.0': 'BSD-3-Clause'}


def notice(identifier: str, holder: str) -> str | None:
    """The LICENSE file: which license it is and where its text stands; None for an identifier that is not known."""
    if identifier not in NAMES:
        return None
    spdx = SPDX.get(identifier, identifier)
    return (
        f'SPDX-License-Identifier: {spdx}\n\nCopyright holder: {holder}\n\n'
        f'This package may be used under the terms of the {NAMES[identifier]}.\n'
        f'Full text: https://spdx.org/licenses/{spdx}.html\n'
    )
