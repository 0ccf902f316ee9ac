"""Guards: input is checked, and signals, threads, forks and errors never leave a match in the middle of a step.

interrupts.py   hold signals such as Ctrl-C back during work that must not be interrupted
checking.py     checks of settings, numbers and names, with one kind of message
names.py        names that are imported on first use, and messages for unknown names
ranges.py       the allowed range of each field of a record, and the check of records
whole_files.py  files that are written whole or not at all
turns.py        methods for one thread at a time, done whole or not at all
workers.py      threads that share the parts of a task
"""
