"""Statistics of play: possession, shots, passes, kinds of goals, the referee's calls.

records.py     the record of the statistics, and of the memory that counting needs
counting.py    one control step: time, restarts, whistles
players.py     each robot: possession, spells, touches, distance covered, time stuck
flights.py     balls on their way: shots, saves, passes
goals.py       kinds of goals
maps.py        heat maps, pass networks, shot maps: noted, and read from a record
figures.py     every statistic with unit and definition; one match as plain numbers from a team's side

Every statistic is counted here, once a control step after the referee, and nowhere else; reports and `infos` read
the record. The record does not influence the match: it is saved, and left out of hashes.
"""
