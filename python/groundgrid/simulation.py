"""Simulated drives with exact labels, heights and terrain."""

from ._core import Drive, SimulatedScan, TrueTerrain, scene_names, sensor_names

__all__ = ["Drive", "SimulatedScan", "TrueTerrain", "scene_names", "sensor_names"]
