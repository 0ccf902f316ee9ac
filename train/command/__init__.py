"""The command `soccer`.

command_line.py      which settings each command reads, and what it prints
match_commands.py    `soccer record`, `replay`, `export` and `watch`
listing.py           `soccer list`
parsing.py           the words of a command into its settings, or one line that says what is wrong; completion of shells
left_out.py          how help shows an option that may be left out
warm_up.py           compile everything ahead of time
compiling_beside.py  compile in two processes, at an empty cache
exit_codes.py        what a command ends with
watching/            a match or a replay in a window: `soccer watch`
"""
