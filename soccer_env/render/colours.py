"""Colours of the pictures, 8 bits each of red, green, blue: home is red, away is blue, goals keep their colours."""

from __future__ import annotations

Colour = tuple[int, int, int]

TEAM_NAMES = ("red", "blue")  # names of home and away for people, as in the legged league of 2001
TEAMS: tuple[Colour, Colour] = ((208, 38, 44), (36, 80, 196))
TEAMS_LIGHT: tuple[Colour, Colour] = ((255, 128, 122), (128, 172, 255))  # legible as text on a dark ground
TEAMS_PALE: tuple[Colour, Colour] = ((244, 205, 200), (204, 218, 248))  # heads
GOALS: tuple[Colour, Colour] = ((250, 204, 38), (84, 184, 240))  # yellow at -x, sky-blue at +x
GOALS_FLOOR: tuple[Colour, Colour] = ((176, 160, 52), (70, 146, 164))

BALL: Colour = (255, 122, 16)
BALL_EDGE: Colour = (120, 48, 0)
BALL_SHINE: Colour = (255, 196, 128)
KEEPER: Colour = (255, 220, 30)

CARPET: Colour = (44, 124, 70)
CARPET_LIGHT: Colour = (48, 131, 75)
BAND: Colour = (38, 110, 62)
LINE: Colour = (240, 244, 240)
BOARD: Colour = (222, 222, 214)
BOARD_EDGE: Colour = (150, 152, 146)
BOARD_FOOT: Colour = (188, 190, 182)
FLOOR: Colour = (38, 43, 51)  # around the field

INK: Colour = (16, 19, 24)
PANEL: Colour = (20, 24, 31)
CHIP: Colour = (48, 55, 67)
WHITE: Colour = (255, 255, 255)
DIM: Colour = (164, 174, 190)
GREY: Colour = (120, 126, 134)  # robots that do not play
PAW: Colour = (232, 233, 236)
STEEL: Colour = (206, 210, 216)
CHASSIS: Colour = (28, 30, 35)
AMBER: Colour = (255, 190, 40)  # a kick under way, a fall
PLAY: Colour = (70, 200, 110)
