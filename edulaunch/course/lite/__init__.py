"""The browser edition, made by `edulaunch course lite`: the engine in Pyodide, a page for it, and the exercises of a course.

`site.py` collects the files, the page calls `in_browser.py`, and `page/` is the page. `page/greenlet.py` replaces
greenlet, which does not exist there: tasks switch by suspending WebAssembly (JSPI). docs/in_the_browser.md has figures.
"""
