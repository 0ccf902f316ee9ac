"""Play, train and measure: everything behind the command `soccer`.

command/             the command line: its words, lists and windows
evaluate/            contests between two teams, recordings, selected replays
cluster/             the work of a command as tasks on a Ray cluster
tournament/          teams ranked by playing each other
report/              charts, and the HTML pages that show them
ppo/                 train a policy                        papers/   measure the claims of the papers
bench/               benchmarks                            examples/ small programs
pages/               tables and pictures of this repository's pages, not in the wheel
casting.py           the teams that play a match or a drill
written_settings.py  parse settings from the command line, and write them as a command
results_folder.py    the folder of a run: resumable, and safe for other files
files.py             files of lines that survive a crash
provenance.py        what a result was made with: versions, hashes of code and teams, date, commit
statistics.py        intervals        progress.py   a progress bar for long work
"""
