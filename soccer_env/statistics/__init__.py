"""Statistics of play: who has the ball, what he does with it, how goals fall, what the referee calls.

records.py     what is counted, and what is remembered to count it
counting.py    one control step: time, restarts, whistles
players.py     possession, spells, touches, idle mates, keepers
moving.py      distance covered, time stuck, places
flights.py     balls on their way: shots, saves, passes
goals.py       how a goal fell
maps.py        heat maps, pass networks, shot maps: noted, and read from a record
figures.py     every statistic with unit and definition; one match as plain numbers from a team's side

Every statistic is counted here, once a control step after the referee, and nowhere else; reports and `infos` read
the record. The future of a match does not depend on it: it is saved, and left out of hashes.
"""
