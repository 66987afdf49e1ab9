"""Choosing how an environment is rendered."""

from typing import TYPE_CHECKING, Any, Literal, get_args

from prospect_mj.checks import check_choice
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.errors import InvalidValue

if TYPE_CHECKING:
    from prospect_mj.envs.pictures import Screen
    from prospect_mj.sim.simulation import Simulation

RenderMode = Literal["rgb_array", "rgb_array_list", "human"]
RENDER_MODES: tuple[RenderMode, ...] = get_args(RenderMode)
STILL_RATE, FILM_RATE = 1, 25
"""Pictures per second: of a slide show with one picture after each action; of a film
or a window at real time."""


NOTHING = "None on recorded physics, where nothing is simulated"


def check_render_mode(mode: object, settings: PickPlaceSettings) -> None:
    """Refuse a mode that there isn't, or a window that would stay empty.

    Pictures of recorded physics are refused when one is asked for: Stable-Baselines3's
    `make_vec_env` asks every environment for `rgb_array`, whether it renders or not.

    Raises:
        InvalidChoice: if there is no such mode.
        InvalidValue: if nothing is simulated that a window could show.
    """
    check_choice("render_mode", mode, (None, *RENDER_MODES))
    if mode == "human" and settings.physics != "live":
        raise InvalidValue("render_mode", mode, NOTHING)


def metadata(mode: RenderMode | None, settings: PickPlaceSettings) -> dict[str, Any]:
    """What Gymnasium's tools want to know of the rendering."""
    rate = STILL_RATE if mode == "rgb_array" else FILM_RATE
    if settings.physics != "live":
        return {"render_modes": [], "render_fps": rate}
    return {"render_modes": [*RENDER_MODES], "render_fps": rate}


def make_screen(
    mode: RenderMode, simulation: "Simulation", settings: PickPlaceSettings
) -> "Screen":
    """Open what shows the live scene.

    Raises:
        NoDisplay: if there is none to open a window on.
        RenderingUnavailable: if there is no OpenGL.
    """
    size = settings.height, settings.width
    # Nothing of MuJoCo is loaded where nothing is simulated, and no window's library
    # where none is opened.
    if mode == "human":
        from prospect_mj.envs.window import Window

        return Window(simulation, size)
    from prospect_mj.envs.pictures import Film, Still

    return Still(simulation, size) if mode == "rgb_array" else Film(simulation, size)
