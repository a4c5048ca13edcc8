"""The colours of pages and reports, light and dark, as CSS variables."""

from __future__ import annotations

from collections.abc import Mapping

LIGHT: Mapping[str, str] = {
    'ground': '#ffffff',
    'text': '#222222',
    'faint': '#555555',
    'link': '#0b57a4',
    'line': '#8a8a8a',
    'passed': '#1a6e2e',
    'failed': '#a3231f',
    'not_run': '#7a5b00',
    'grader_broke': '#6b2a8c',
    'mark': '#ffe9a8',
    'same': '#d9ecff',
}
DARK: Mapping[str, str] = {
    'ground': '#15181d',
    'text': '#e6e6e6',
    'faint': '#b4b8be',
    'link': '#8ab4f8',
    'line': '#767b84',
    'passed': '#6fcf85',
    'failed': '#ff8f86',
    'not_run': '#e6c068',
    'grader_broke': '#d7a5f0',
    'mark': '#5c4a00',
    'same': '#12395c',
}


def variables(colours: Mapping[str, str]) -> str:
    """Return the colours as CSS variables."""
    return ''.join(f'--{name}:{value};' for name, value in colours.items())


def colour(name: str) -> str:
    """Return a CSS colour for the style of an element. On a page without the variables, it is the light colour."""
    return f'var(--{name},{LIGHT[name]})'


PAGE = (
    f':root{{color-scheme:light dark;{variables(LIGHT)}}}'
    f'@media(prefers-color-scheme:dark){{:root{{{variables(DARK)}}}}}'
    'body{color:var(--text);background:var(--ground)}a{color:var(--link)}'
)
"""The first rules of every page. The browser selects the scheme."""
NOTEBOOK = f'[data-jp-theme-light="false"] .edugrade{{{variables(DARK)}}}'
"""The rule for a report in a cell: JupyterLab marks a dark theme with this attribute."""
