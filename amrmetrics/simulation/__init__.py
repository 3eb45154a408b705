"""Seeded robots and what they measure: data whose truth is known.

The source lesson's demonstration, which lecture 00 measures; a planar robot among landmarks
with filters that are consistent and filters that are not, for lecture 04; a robot that
maps a building with a range scanner, for lectures 05 and 06; and a drive through a city of
look-alike blocks with the loop closures that a detector proposes, for lecture 07.
"""

from .city import CityRun, city_run
from .filters import (
    LANDMARKS,
    Log,
    Run,
    drive,
    ekf_localization,
    ekf_slam,
    measurement_model,
    motion_model,
)
from .lesson import SAMPLES, Demonstration, demonstration
from .mapping import Scans, occupancy_grid, point_map, scan_room

__all__ = [
    "LANDMARKS",
    "SAMPLES",
    "CityRun",
    "Demonstration",
    "Log",
    "Run",
    "Scans",
    "city_run",
    "demonstration",
    "drive",
    "ekf_localization",
    "ekf_slam",
    "measurement_model",
    "motion_model",
    "occupancy_grid",
    "point_map",
    "scan_room",
]
