"""`train --seeds`: several runs by one command."""

import json

import pytest
from folder_tree import tree
from ideal_env import IdealEnv, refuse

from prospect_mj.cli import train
from prospect_mj.experiment.run.run_folder import RunFolder


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "thesis.tex").touch()
    return tmp_path


def main(words, make_env=IdealEnv):
    return train.main(f"--trials 3 --jobs 1 {words}".split(), make_env=make_env)


BAD = {
    "--seeds": "--seeds",
    "--seeds all": "0:8, 0:8:2 or 0,3,5",
    "--seeds 8:0": "8:0",
    "--seeds 0:8:0": "0:8:0",
    "--seeds 0,0": "each once",
    "--seeds 0:99999": "at most 10000",
    "--seeds 0:2 --seed 0": "--seed is 0; expected none beside --seeds",
    "--seeds 0:2 --seed=4": "--seed is 4; expected none beside --seeds",
    "--seeds 0:2 --resume full": "--resume is 'full'; expected none beside --seeds",
    "--seeds 0:2 --out full": "full is not empty",
    "--seeds 0:2 --jobs 0": "jobs is 0",
    "--seeds 0:2 --jobs 100000": "jobs is 100000",
    "--seeds 0:2 --physics recorded --record all": "none on recorded physics",
    "--seeds 0:2 --jobs 2 --grow": "--jobs is 2; expected 1 beside --grow",
}


@pytest.mark.parametrize(("words", "named"), BAD.items(), ids=BAD.keys())
def test_bad_input_is_one_line_and_changes_nothing(words, named, refused):
    assert named in refused(lambda: main(words))


def test_runs_are_made_where_it_says_and_summed_up(elsewhere, capsys):
    assert main("--seeds 0:4:2") == 0
    said = capsys.readouterr().out
    assert said.startswith("training in runs/seeds; the same command goes on")
    assert any(line.startswith("mean ") for line in said.splitlines())
    for seed in (0, 2):
        with RunFolder.open(elsewhere / f"runs/seeds/seed-000{seed}") as run:
            assert (run.config.seed, run.n_trials) == (seed, 3)


def test_the_same_again_runs_nothing(elsewhere, capsys):
    main("--seeds 0:2")
    before, first = tree(elsewhere), capsys.readouterr().out
    assert main("--seeds 0:2", refuse) == 0
    assert capsys.readouterr().out.splitlines() == first.splitlines()[1:]
    assert tree(elsewhere) == before


def test_another_configuration_is_one_line(refused):
    main("--seeds 0:2")
    line = refused(lambda: main("--seeds 0:2 --supervisor safe"))
    assert "runs/seeds/seed-0000 is another run: its supervisor is none" in line


def test_a_program_gets_one_json_object(capsys):
    assert main("--seeds 0:2 --json") == 0
    said = capsys.readouterr()
    found = json.loads(said.out)
    assert [one["seed"] for one in found["seeds"]] == [0, 1]
    assert found["first_mean"].keys() == {"estimate", "low", "high"}
    assert "training in" in said.err


@pytest.mark.parametrize("words", ["--out two --json", "--resume one --json"])
def test_a_single_run_has_its_json_too(words, capsys):
    main("--out one")
    capsys.readouterr()
    assert main(words) == 0
    assert json.loads(capsys.readouterr().out)["trials"] == 3


def test_an_interrupted_one_goes_on(elsewhere, capsys):
    class Interrupted(IdealEnv):
        def reset(self, *, seed, options):
            if options["trial"] == 2:
                raise KeyboardInterrupt
            return super().reset(seed=seed, options=options)

    assert main("--seeds 0:2 --out cut", Interrupted) == 130
    assert "all finished trials are kept" in capsys.readouterr().err
    assert main("--seeds 0:2 --out cut") == 0
    assert main("--seeds 0:2 --out whole") == 0
    cut, whole = tree(elsewhere / "cut"), tree(elsewhere / "whole")
    assert list(cut.values()) == list(whole.values())
