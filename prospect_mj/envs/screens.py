"""Choosing how an environment is rendered."""

from typing import TYPE_CHECKING, Any, Literal, get_args

from prospect_mj.checks import check_choice
from prospect_mj.display import require_display
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
_INSTEAD = (
    "without one render_mode='rgb_array' gives pictures, 'rgb_array_list' whole films"
)


def check_render_mode(mode: object, settings: PickPlaceSettings) -> None:
    """Refuse a mode that there isn't, or a window that can't be or would stay empty.

    Pictures of recorded physics are refused when one is asked for: Stable-Baselines3's
    `make_vec_env` asks every environment for `rgb_array`, whether it renders or not.

    Raises:
        InvalidChoice: if there is no such mode.
        InvalidValue: if nothing is simulated that a window could show.
        NoDisplay: if there is none to open a window on.
    """
    check_choice("render_mode", mode, (None, *RENDER_MODES))
    if mode == "human":
        if settings.physics != "live":
            raise InvalidValue("render_mode", mode, NOTHING)
        require_display(_INSTEAD)


def metadata(mode: RenderMode | None, settings: PickPlaceSettings) -> dict[str, Any]:
    """What Gymnasium's tools want to know of the rendering."""
    rate = STILL_RATE if mode == "rgb_array" else FILM_RATE
    if settings.physics != "live":
        return {"render_modes": [], "render_fps": rate}
    return {"render_modes": [*RENDER_MODES], "render_fps": rate}


def make_screen(
    mode: RenderMode, simulation: "Simulation", settings: PickPlaceSettings
) -> "Screen":
    """Open what shows the live scene; `check_render_mode` has let it pass.

    Args:
        mode: how it is shown.
        simulation: the live physics.
        settings: have the size of a picture.
    """
    size = settings.height, settings.width
    # Nothing of MuJoCo is loaded where nothing is simulated, and no window's library
    # where none is opened.
    if mode == "human":
        from prospect_mj.envs.window import Window

        return Window(simulation, size)
    from prospect_mj.envs.pictures import Film, Still

    return Still(simulation, size) if mode == "rgb_array" else Film(simulation, size)
