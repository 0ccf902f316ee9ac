"""The command line program `soccer`.

command_line.py      the commands: the settings that each command reads, and the text that it prints
match_commands.py    `soccer tournament`, `record`, `replay`, `export`, `watch` and `play`
printing.py          print tables, JSON, and the files of a run
listing.py           `soccer list`
parsing.py           parse a command's words into its settings, or report the error in one line; shell completion
left_out.py          how the help shows an optional value
warm_up.py           compile everything ahead of time
compiling_beside.py  compile in two processes when the cache is empty
exit_codes.py        exit codes                       interrupts.py  Ctrl-C that Python swallows, sent once more
watching/            a match or a replay in a window: `soccer watch`
playing/             a match that a person plays in: `soccer play`
"""
