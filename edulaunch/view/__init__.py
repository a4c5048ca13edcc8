"""The live desk: one page that shows a machine or a recording, and lets a student stop it, step it and look back.

`film` turns what was recorded into plain data, piece by piece; `page` is the front end that draws it. The same page stands in a
notebook, beside a terminal, in an exported file and in a report of `edugrade`.
"""

TABS = ('frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters', 'terminal')
"""What can stand beside the turtles."""
