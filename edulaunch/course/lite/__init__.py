"""The edition for a browser, which `edulaunch course lite` makes: the engine in Pyodide, a desk around it, exercises of a course.

`site.py` puts the files together, `in_browser.py` is what the page calls, `page/` is the page. `page/greenlet.py` stands for
greenlet, which does not exist there: tasks are switched by suspending WebAssembly (JSPI). Figures: docs/in_the_browser.md.
"""
