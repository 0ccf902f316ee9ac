"""How legged robots recognise other players, and remember them.

blobs.py         A player's range from all its blobs or the largest one, while its head stickers come and go.
ghosts.py        What a ghost costs the memory of other players, and what a player that is missed costs it.
grouping.py      Which blobs are one player: how often one is missed or a ghost is seen, and who is missed.
head_down.py     A robot nearby that looks down at the ball: its black head hides its jersey.
jersey.py        A jersey of stickers, seen from all sides and from afar.
memory.py        Whether one opponent fills the whole memory of opponents, by how they are matched.
moving.py        Where another player has gone by the time that one who saw it from afar gets there.
range.py         How well a legged robot tells the range of another player: against the ball's, and by infrared.
seen.py          Stage robots that look at other players; compare what they believe of them with the truth.
tracked.py       How many other players a robot keeps track of, and how well: the old system and the new one.
views.py         Under which angles players see each other in play.
"""
