"""Advice on recordings with a ferry."""

from edulaunch.advice.rule import found, rule


@rule(
    'programs.two-ferries',
    what='{count} ferries use one landing stage: {nodes}',
    why='both publish their position on the same topic',
    do='start one of them in a namespace of its own',
)
def two_ferries(recording):
    """More than one ferry without a namespace."""
    nodes = [node.name for node in recording.nodes if node.name.startswith('/ferry')]
    if len(nodes) > 1:
        yield found('node', nodes[-1], count=len(nodes), nodes=nodes)
