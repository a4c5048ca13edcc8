"""The destinations of a program's output."""

from __future__ import annotations

from collections.abc import Iterable

OutputConfig = str | dict[str, str | Iterable[str]]

SOURCES = ('stdout', 'stderr', 'both')
DESTINATIONS = ('screen', 'log', 'own_log')
_NAMED: dict[str, dict[str, set[str]]] = {
    'screen': {'both': {'screen'}},
    'log': {'both': {'log'}, 'stderr': {'screen'}},
    'both': {'both': {'log', 'screen'}},
    'own_log': {'both': {'own_log'}, 'stdout': {'own_log'}, 'stderr': {'own_log'}},
    'full': {'both': {'screen', 'log', 'own_log'}, 'stdout': {'own_log'}, 'stderr': {'own_log'}},
}


def normalize_output_configuration(config: OutputConfig) -> dict[str, set[str]]:
    """Return the set of destinations for each of 'stdout', 'stderr' and 'both'.

    :raises ValueError: for an unknown name, source or destination.
    """
    places: dict[str, set[str]] = {source: set() for source in SOURCES}
    if isinstance(config, str):
        if config not in _NAMED:
            raise ValueError(f'{config} is not a valid standard output config i.e. "screen", "log" or "both"')
        places.update(_NAMED[config])
        return places
    for source, destinations in config.items():
        if source not in SOURCES:
            raise ValueError(f'{source} is not a valid output source i.e. "stdout", "stderr" or "both"')
        places[source] = {destinations} if isinstance(destinations, str) else set(destinations)
        for destination in sorted(places[source]):
            if destination not in DESTINATIONS:
                raise ValueError(f'{destination} is not a valid output destination i.e. "screen", "log" or "own_log"')
    return places
