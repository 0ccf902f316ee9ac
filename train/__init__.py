"""Play, train and measure: everything behind the command `soccer`.

command_line.py      the command: which settings it reads and what it prints         listing.py   `soccer list`
match_commands.py    `soccer record`, `replay`, `export` and `watch`                 exit_codes.py
evaluate/            one team against another; record and replay a match             bench/       `soccer bench`
watching/            a match or a replay in a window: `soccer watch`
ppo/                 train a policy                                                  pictures/    of the pages
reproduce/           what the papers claim, measured                                 tables/      tables of the pages
keeping/             replays of matches worth keeping                                examples/    small programs
report_pages/        reports as pages
parsing.py           the words of a command into its settings, or one line that says what is wrong; completion of shells
warm_up.py           compile everything ahead of time         casting.py   who plays a match or a drill
compiling_beside.py  compile in two processes, at an empty cache
written_settings.py  how settings are written: out of a user's words, and back into a command
results_folder.py    the folder of a run's results, that goes on and touches nothing of others
files.py             files of lines that survive a crash
provenance.py        what a result was made with: versions, hashes of code and teams, date, commit
statistics.py        intervals        plots/   pictures of results        progress.py   how far a long piece of work is
"""
