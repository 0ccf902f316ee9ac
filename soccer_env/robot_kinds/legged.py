"""The kind of robot that plays the legged league."""

from soccer_env.belief.legged.believe import LEGGED_MEMORY, believe_slice
from soccer_env.belief.legged.talk import SOUND_MESSAGE
from soccer_env.belief.particles import PARTICLE
from soccer_env.leagues.robot_kind import RobotKind
from soccer_env.observations.legged import entries, observe_slice
from soccer_env.perception.legged.calibration import calibrate
from soccer_env.perception.legged.sense import LEGGED_SENSOR_STATE, sense_slice
from soccer_env.records.percepts import LEGGED_PERCEPT

LEGGED = RobotKind(
    percept=LEGGED_PERCEPT,
    sensor_state=LEGGED_SENSOR_STATE,
    memory=LEGGED_MEMORY,
    message=SOUND_MESSAGE,
    particle=PARTICLE,
    sense=sense_slice,
    believe=believe_slice,
    entries=entries,
    observe=observe_slice,
    tables=calibrate,
)
