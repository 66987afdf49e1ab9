"""The command that evaluates a run."""

import json
from pathlib import Path

import pytest
from ideal_env import IdealEnv, refuse

from prospect_mj.cli import evaluate
from prospect_mj.experiment.run.kept_episodes import kept_trials


class Watched(IdealEnv):
    """It can be watched, though there is nothing to see."""

    def watch(self):
        return self

    def episode(self):
        return None


@pytest.fixture(autouse=True)
def unseen(monkeypatch):
    """Episodes of nothing are files without content."""
    from prospect_mj.experiment.run import episode_keeper

    monkeypatch.setattr(
        episode_keeper.episode_file, "write", lambda path, *_: path.touch()
    )


@pytest.fixture
def run(existing):
    return existing / "run"


def main(words, make_env=Watched):
    return evaluate.main(words.split(), make_env=make_env)


BAD = {
    "": "RUN",
    "nowhere": "nowhere is not a run folder",
    "full": "full is not a run folder",
    "file": "file is not a run folder",
    "run run": "run",
    "run --trails 5": "--trails",
    "run --trials 1": "2 to",
    "run --trials many": "many",
    "run --trials 9999999999": "50000",
    "run --seed -1": "-1",
    "run --seed 1.5": "1.5",
    "run --physics dreamt": "dreamt",
    "run --out full": "full is not empty",
    "run --out run": "run is not empty",
    "run --out file": "file is not a folder",
    "run --out file/below": "file/below can't be made",
    "run --record some": "--record is 'some'; expected all, failures or every=N",
    "run --record every=0": "every=N",
    f"run --record every={'9' * 5000}": "expected an integer from 1 to",
    "run --physics recorded --record all": "none on recorded physics",
}


@pytest.mark.parametrize(
    ("words", "named"), BAD.items(), ids=[words[:40] for words in BAD]
)
def test_bad_input_is_one_line_and_changes_nothing(words, named, run, refused):
    assert named in refused(lambda: main(words))


def test_a_broken_installation_is_one_line_and_no_folder(run, refused):
    assert "error: no OpenGL library" in refused(lambda: main("run", refuse))


def test_it_says_where_and_shows_a_table(run, capsys):
    assert main("run --trials 2 --longer") == 0
    said = capsys.readouterr()
    assert said.err == ""
    first, *others = said.out.splitlines()
    assert first.startswith("evaluating in run/evaluations/0001; ")
    assert any(line.split()[:2] == ["all", "4"] for line in others)
    assert others[-1] == "evaluation folder: run/evaluations/0001"
    assert any(line.startswith("more than 2 actions: ") for line in others)


def test_the_same_again_shows_the_same_without_a_trial(run, capsys):
    main("run --trials 2")
    first = capsys.readouterr().out.splitlines()[1:]
    assert main("run --trials 2", refuse) == 0
    words, *again = capsys.readouterr().out.splitlines()
    assert words == "run/evaluations/0001 is finished"
    assert again == first


def test_a_program_gets_one_json_object(run, capsys):
    assert main("run --trials 2 --json") == 0
    said = capsys.readouterr()
    found = json.loads(said.out)
    assert found["path"] == "run/evaluations/0001"
    assert found["outcomes"]["all"]["trials"] == 4
    low, mid, high = (
        found["outcomes"]["all"]["success"][name]
        for name in ("low", "estimate", "high")
    )
    assert 0 <= low <= mid <= high <= 1
    assert len(found["failures"]) == 4 - found["outcomes"]["all"]["solved"]
    assert "evaluating in" in said.err


def test_failures_are_kept_unless_something_else_is_asked_for(run):
    # Two trials teach nothing: the same useless action again and again.
    main("run --trials 2 --out kept")
    main("run --trials 2 --out some --record every=3")
    assert kept_trials(Path("kept")) == [0, 1, 2, 3]
    assert kept_trials(Path("some")) == [0, 3]


def test_an_interrupted_one_goes_on(run, capsys):
    class Interrupted(Watched):
        def reset(self, *, seed, options):
            Interrupted.left -= 1
            if Interrupted.left < 0:
                raise KeyboardInterrupt
            return super().reset(seed=seed, options=options)

    Interrupted.left = 3
    assert main("run --trials 2", Interrupted) == 130
    assert "all finished trials are kept" in capsys.readouterr().err
    assert main("run --trials 2") == 0
    words = capsys.readouterr().out.splitlines()[0]
    assert words == "evaluating in run/evaluations/0001; at trial 3"


def test_a_run_of_older_software_is_evaluated_with_a_warning(run, capsys):
    config = run / "config.yaml"
    installed = next(
        line for line in config.read_text().splitlines() if " mujoco: " in line
    )
    config.write_text(config.read_text().replace(installed, "  mujoco: 3.1.0"))
    assert main("run --trials 2") == 0
    assert capsys.readouterr().err == "warning: run learned before a change of mujoco\n"


def test_of_recorded_physics_nothing_is_kept(run):
    assert main("run --trials 2 --physics recorded", IdealEnv) == 0
    assert not (run / "evaluations" / "0001" / "episodes").exists()
