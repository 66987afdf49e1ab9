"""What a command prints for programs is JSON, and nothing else stands beside it."""

import json
import math
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from ideal_env import IdealEnv

from prospect_mj.cli import bench, reproduce, train
from prospect_mj.cli.output import Output, as_json
from prospect_mj.experiment.populations.costs import Cost
from prospect_mj.experiment.studies.bench import BenchResult


class Level(StrEnum):
    BAD = "bad"


@dataclass(frozen=True)
class Figures:
    path: Path
    values: tuple[float, ...]
    level: Level


def test_figures_become_one_object():
    figures = Figures(Path("a/b"), (1.5, math.nan, -math.inf), Level.BAD)
    assert json.loads(as_json(figures)) == {
        "path": "a/b",
        "values": [1.5, None, None],
        "level": "bad",
    }
    nested = {1: [figures], "array": np.array([[1.0, np.nan]]), "n": np.int64(3)}
    found = json.loads(as_json(nested))
    assert found["1"][0]["path"] == "a/b"
    assert found["array"] == [[1.0, None]]
    assert found["n"] == 3


def test_what_json_can_not_say_is_a_programming_error():
    with pytest.raises(TypeError):
        as_json({"it": object()})


def test_words_go_where_they_disturb_nobody(capsys):
    Output(json=True).say("on the way")
    Output(json=True).result("done", {"n": 1})
    assert capsys.readouterr() == ('{"n": 1}\n', "on the way\n")
    Output().say("on the way")
    Output().result("done", {"n": 1})
    assert capsys.readouterr() == ("on the way\ndone\n", "")
    Output().result("", {"n": 1})
    assert capsys.readouterr() == ("", "")


def test_a_training_sums_up_for_programs(tmp_path, capsys):
    out = tmp_path / "run"
    options = ["--trials", "3", "--json", "--out", str(out)]
    assert train.main(options, make_env=IdealEnv) == 0
    said = capsys.readouterr()
    found = json.loads(said.out)
    assert (found["trials"], found["path"]) == (3, str(out))
    assert found["last_mean"] >= 2
    assert said.err.startswith("training in ")


def test_a_refusal_prints_no_object(capsys):
    assert train.main(["--json", "--trials", "0"], make_env=IdealEnv) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1


def test_a_bench_gives_the_same_figures_both_ways(monkeypatch, capsys):
    measured = BenchResult(20.0, 8.0, {"mj_step": 0.25, "other": 0.75}, 0.04)
    ticks = []

    def instead(config, tick):
        ticks.extend(tick() for _ in range(config.trials))
        return measured

    costs = [Cost("linear", 0.005, 1e-6, 3e-4, 14000), Cost("new", 0.01, 3e-6, 6e-4, 7)]
    monkeypatch.setattr(bench, "bench", instead)
    monkeypatch.setattr(bench, "measured_costs", lambda recording: costs)
    assert bench.main(["--trials", "4", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["times_real_time"] == 2.5
    assert found["shares_of_wall_time"] == {"mj_step": 0.25, "other": 0.75}
    assert found["learners"][1] == costs[1]._asdict()
    assert bench.main(["--trials", "4"]) == 0
    words = capsys.readouterr().out
    assert "2.5 simulated seconds per wall second" in words
    assert "40 ms" in words
    head, first, second = words.splitlines()[-3:]
    assert head.split()[:2] == ["learner", "ms"]
    assert first.startswith("linear")
    assert second.split()[:4] == ["new", "10", "(x", "2)"]
    assert len(ticks) == 8


def test_a_reproduction_gives_the_statements_beside_what_was_measured(
    tmp_path, monkeypatch, capsys
):
    def instead(recording, config, out, jobs, live, tick):
        out.mkdir()
        rows = [{"statement": "It learns.", "measured": math.nan, "verdict": "holds"}]
        pq.write_table(pa.Table.from_pylist(rows), out / "statements.parquet")
        return out / "report.md"

    monkeypatch.setattr(reproduce, "reproduce", instead)
    out = tmp_path / "it"
    assert reproduce.main(["--out", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == {
        "report": str(out / "report.md"),
        "statements": [
            {"statement": "It learns.", "measured": None, "verdict": "holds"}
        ],
    }
