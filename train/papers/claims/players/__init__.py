"""How legged robots recognise other players, and remember them.

blobs.py         A player's range from all its blobs or the largest one, while its head stickers come and go.
ghosts.py        The damage of a ghost and of a missed player to the memory of other players.
grouping.py      Grouping blobs into players: missed players, ghosts, and which player is missed.
head_down.py     A robot nearby that looks down at the ball: its black head hides its jersey.
jersey.py        A jersey of stickers, seen from all sides and from afar.
memory.py        One opponent that fills the whole memory of opponents, and the rules of matching.
moving.py        The movement of a player between an early sighting and the encounter.
range.py         The accuracy of another player's range: against the ball's, and by infrared.
watching.py      Stage robots that look at other players; compare their beliefs with the truth.
tracked.py       The number and accuracy of tracked players: the old system and the new one.
views.py         The angles from which players see each other in play.
"""
