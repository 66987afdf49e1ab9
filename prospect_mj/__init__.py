"""A two-armed torso in MuJoCo that learns which hand to pick an object up with."""

from importlib.metadata import PackageNotFoundError, version

try:
    __version__ = version("prospect-mj")
except PackageNotFoundError:  # a checkout on PYTHONPATH, never installed
    __version__ = "0+unknown"
