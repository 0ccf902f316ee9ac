"""Tables as files: CSV, or Parquet by pyarrow (extra `data`): NAME.csv (tracking), NAME_events.csv, NAME_beliefs.csv.

Matches are written one after another, so that many matches take no more memory than the longest. Files appear whole or
not at all.
"""

import csv
from collections.abc import Iterable
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.data_out.tables import TABLES, Column, Table
from soccer_env.guards.whole_files import atomic_file

HOW = 'pip install "soccer_env[data]"'


def table_paths(path: Path, beliefs: bool = False) -> dict[str, Path]:
    """Return the files of the tables by name."""
    more = ("events", "beliefs")[: 1 + beliefs]
    return {"tracking": path} | {name: path.with_name(f"{path.stem}_{name}{path.suffix}") for name in more}


def require_writer(kind: str) -> None:
    """Raise ImportError, which says what to install, if files with this ending cannot be written."""
    if kind == ".parquet":
        try:
            import pyarrow.parquet  # noqa: F401
        except ImportError as error:
            raise ImportError(f"Parquet needs pyarrow: {HOW}") from error


def write_tables(matches: Iterable[dict[str, Table]], path: Path, beliefs: bool = False) -> dict[str, Path]:
    """Write the tables of matches as CSV or Parquet, by the path's ending; return the path of each table.

    ImportError if pyarrow is missing. Existing files are replaced after all matches are written.
    """
    kind: type[CsvFile] | type[ParquetFile] = CsvFile if path.suffix.lower() == ".csv" else ParquetFile
    paths = table_paths(path, beliefs)
    with ExitStack() as replacing, ExitStack() as closing:  # all are closed before the first is replaced
        files: dict[str, CsvFile | ParquetFile] = {}
        for name, target in paths.items():
            files[name] = kind(replacing.enter_context(atomic_file(target)), TABLES[name])
            closing.callback(files[name].close)
        for tables in matches:
            for name, file in files.items():
                file.add(tables[name])
    return paths


class CsvFile:
    """A table as CSV: comma, quotes where needed, LF, a first line with the names; flags are true and false."""

    def __init__(self, path: Path, columns: tuple[Column, ...]) -> None:
        self._columns = columns
        self._file = path.open("x", encoding="utf-8", newline="")
        self._writer = csv.writer(self._file, lineterminator="\n")
        self._writer.writerow([column.name for column in columns])

    def add(self, table: Table) -> None:
        """Append the rows of a table to the file."""
        self._writer.writerows(
            zip(*(column_as_text(table[column.name], column) for column in self._columns), strict=True)
        )

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def column_as_text(values: np.ndarray, column: Column) -> list[Any]:
    """Return a column as text: numbers with six decimals, missing numbers empty."""
    if column.kind == "flag":
        return ["true" if value else "false" for value in values.tolist()]
    if column.kind == "number":
        return [round(value, 6) if value == value else "" for value in values.tolist()]
    if column.kind == "text":
        return [escape_formula(value) for value in values.tolist()]
    plain: list[Any] = values.tolist()
    return plain


def escape_formula(text: str) -> str:
    """Return a word that no spreadsheet takes for a formula: names of matches come from untrusted files."""
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text


class ParquetFile:
    """A table as Parquet; unit and meaning of each column stand in the metadata of its field."""

    def __init__(self, path: Path, columns: tuple[Column, ...]) -> None:
        require_writer(".parquet")
        import pyarrow
        from pyarrow import parquet

        string, whole, number, flag = pyarrow.string(), pyarrow.int64(), pyarrow.float64(), pyarrow.bool_()
        kinds = {"text": string, "whole": whole, "number": number, "flag": flag}
        fields = [
            pyarrow.field(column.name, kinds[column.kind], metadata={"unit": column.unit, "text": column.text})
            for column in columns
        ]
        self._table, self._schema = pyarrow.table, pyarrow.schema(fields)
        self._writer = parquet.ParquetWriter(path, self._schema)

    def add(self, table: Table) -> None:
        """Append the rows of a table to the file; numbers that do not apply are null."""
        import pyarrow

        columns = [pyarrow.array(table[field.name], field.type, from_pandas=True) for field in self._schema]
        self._writer.write_table(self._table(columns, schema=self._schema))

    def close(self) -> None:
        """Close the file."""
        self._writer.close()
