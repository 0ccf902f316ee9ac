"""What keeps a match whole where Python lets control go elsewhere: signals, threads, forks, code that raises.

interrupts.py   hold Ctrl-C back while something is done that must not be left half done
turns.py        one thread at a time, and what it does whole or not at all
workers.py      threads that share out a task; none of them runs on when the task has failed, none is lost in a fork
"""
