"""Data out of replays: tidy tables, the Common Data Format, kloppy's datasets.

collect.py      plays a replay and collects places and events       events.py       events of a match, one by one
tables.py       tidy tables, every column with unit and meaning     table_files.py  tables as CSV and Parquet
standard.py     the Common Data Format                              kloppy_data.py   datasets of kloppy
belief_errors.py  `errors_of`: beliefs beside truth
"""

from soccer_env.data_out.kloppy_data import kloppy_events, kloppy_tracking

__all__ = ["kloppy_events", "kloppy_tracking"]
