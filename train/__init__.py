"""Play, train and measure: everything behind the command `soccer`.

command/             the command line: its words, lists and windows
evaluate/            one team against another; record and replay a match; replays that are kept
report/              pictures of results, and pages that hold them
ppo/                 train a policy                                  papers/   what the papers claim, measured
bench/               how fast it is                                  examples/ small programs
pages/               tables and pictures of this repository's pages, not in the wheel
casting.py           who plays a match or a drill
written_settings.py  how settings are written: out of a user's words, and back into a command
results_folder.py    the folder of a run's results, that goes on and touches nothing of others
files.py             files of lines that survive a crash
provenance.py        what a result was made with: versions, hashes of code and teams, date, commit
statistics.py        intervals        progress.py   how far a long piece of work is
"""
