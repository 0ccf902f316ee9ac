"""How legged robots recognise other players, and remember them.

grouping.py  blobs into players             jersey.py    stickers, all or the largest
memory.py    filled slots, ghosts, misses   moving.py    a player that walks on
range.py     against the ball's, infrared   tracked.py   how many, how accurately
views.py     angles of view in play         watching.py  stages robots that look
"""
