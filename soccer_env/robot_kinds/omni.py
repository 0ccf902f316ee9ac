"""The kind of robot that plays the middle-size league."""

from soccer_env.belief.omni.believe import OMNI_MEMORY, believe_slice
from soccer_env.belief.omni.radio import RADIO_MESSAGE
from soccer_env.belief.particles import PARTICLE
from soccer_env.leagues.robot_kind import RobotKind
from soccer_env.observations.omni import entries, observe_slice
from soccer_env.perception.omni.sense import OMNI_SENSOR_STATE, line_tables, sense_slice
from soccer_env.records.percepts import OMNI_PERCEPT

OMNI = RobotKind(
    percept=OMNI_PERCEPT,
    sensor_state=OMNI_SENSOR_STATE,
    memory=OMNI_MEMORY,
    message=RADIO_MESSAGE,
    particle=PARTICLE,
    sense=sense_slice,
    believe=believe_slice,
    entries=entries,
    observe=observe_slice,
    tables=line_tables,
    late=lambda sensors: sensors.camera_delay,
)
