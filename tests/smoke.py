"""What an installed package must be able to do; run outside of the checkout.

    python smoke.py FOLDER PHYSICS

FOLDER is where the package is installed, with its entry points in FOLDER/bin; PHYSICS
is live or recorded: live trials first compile the planner, for many seconds.
"""

import json
import subprocess
import sys
from pathlib import Path


def prospect(installed: Path, *words: str) -> str:
    """What a command prints; one that fails ends the test with its words."""
    command = [sys.executable, installed / "bin" / "prospect", *words]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def check_model(installed: Path) -> None:
    """The torso compiles, from the files that came along."""
    import mujoco

    from prospect_mj import paths

    assert paths.torso_xml().is_relative_to(installed)
    assert paths.jar_obj().is_relative_to(installed)
    assert mujoco.MjModel.from_xml_path(str(paths.torso_xml())).nu >= 14


def check_environments(physics: str) -> None:
    """Live and recorded physics can be had by their name, and other worlds.

    A live jar is seen, and picked up if trials are to be live.
    """
    import gymnasium

    import prospect_mj  # noqa: F401

    recorded, live = {"physics": "recorded"}, {"physics": "live"}
    for settings in (recorded, live, live | {"world": "post"}):
        env = gymnasium.make("prospect_mj/PickPlace-v0", **settings)
        _, info = env.reset(seed=0, options={"orientation": "left"})
        assert info["result"] == "found", info
        if settings is recorded or physics == "live":
            *_, info = env.step(0)
            assert (info["result"], info["holding"]) == ("success", "left"), info
        env.close()


def check_commands(installed: Path, physics: str) -> None:
    """A run can be made and drawn, or replayed where physics is live."""
    assert prospect(installed, "--version").strip()
    few = ("--trials", "1", "--max-actions", "3", "--out", "run")
    if physics == "recorded":
        prospect(installed, "train", *few, "--physics", physics)
        prospect(installed, "plot", "run")
        assert Path("run", "plots", "strategies.png").stat().st_size > 10_000
        return
    checks = json.loads(prospect(installed, "doctor", "--json"))
    found = {check["found"].partition(":")[0] for check in checks["checks"]}
    assert "standard" in found
    prospect(installed, "train", *few, "--record", "all")
    prospect(installed, "replay", "run", "--trial", "0", "--save", "trial.rrd")
    assert Path("trial.rrd").stat().st_size > 10_000
    # The others learn from live physics as the paper's does.
    for learner in ("replay", "table", "discovery"):
        rule = ("--failed-actions", "suppressed", "--gross-motion", "cartesian")
        folder = f"run-{learner}"
        others = (*few[:-1], folder, "--learner", learner, *rule)
        prospect(installed, "train", *others)
        prospect(installed, "evaluate", folder, "--trials", "2")


if __name__ == "__main__":
    where, how = Path(sys.argv[1]).resolve(), sys.argv[2]
    check_model(where)
    check_environments(how)
    check_commands(where, how)
