"""What comes from outside is checked, and a match stays whole where signals, threads, forks or errors come in.

interrupts.py   hold Ctrl-C back while something is done that must not be left half done
checking.py     checks of what somebody gives, with one kind of message
names.py        names imported when they are used, and what to say of unknown ones
ranges.py       what the fields of records may hold, and the check of it
whole_files.py  files that are written whole or not at all
turns.py        one thread at a time, and what it does whole or not at all
workers.py      threads that share out a task; none of them runs on when the task has failed, none is lost in a fork
"""
