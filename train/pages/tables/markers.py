"""The markers in a page between which a table stands."""


def between_markers(text: str, name: str, table: str) -> str:
    """Return a page with a table between its markers; ValueError for a marker that is missing."""
    begin, end = f"<!-- table: {name} -->", f"<!-- end of table: {name} -->"
    before, found, rest = text.partition(begin)
    _, closed, after = rest.partition(end)
    if not found or not closed:
        raise ValueError(f"the page lacks the markers of table {name}")
    return f"{before}{begin}\n{table}\n{end}{after}"
