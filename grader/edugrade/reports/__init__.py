"""Reports: one document, and what a terminal, a page, JUnit and a learning platform make of it."""
