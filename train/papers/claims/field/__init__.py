"""The potential field that a dribbler follows, in a world of points and with robots.

Points have neither camera nor surface: their distances count from middle to middle (MS54). Distances of robots count
from camera to surface, as the sensors gave them (MS42), and for comparison from middle to middle.
"""
