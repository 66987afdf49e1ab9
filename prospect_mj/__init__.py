"""A two-armed torso in MuJoCo that learns which hand to pick an object up with.

Importing it registers the Gymnasium environment `prospect_mj/PickPlace-v0`; MuJoCo
itself is only loaded when the environment is made.
"""

from importlib.metadata import PackageNotFoundError, version

from prospect_mj.envs import register_envs
from prospect_mj.sim import gl

try:
    __version__ = version("prospect-mj")
except PackageNotFoundError:  # a checkout on PYTHONPATH, never installed
    __version__ = "0+unknown"

# Before anything imports mujoco or dm_control, which choose for good at import.
gl.configure()
register_envs()
