"""On live physics: what fails is kept, and all else can be simulated again."""

import pytest
from left_handed import left_handed

from prospect_mj.episodes import episode_file
from prospect_mj.experiment.evaluation.evaluate import evaluate
from prospect_mj.experiment.run.kept_episodes import Kept, kept_trials, path_of
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.watching.resimulate import resimulate

pytestmark = pytest.mark.gl


def test_failures_are_kept_and_others_can_be_simulated_again(tmp_path):
    run = left_handed(tmp_path / "run", trials=1, max_actions=2)
    settings, kept = EvaluationSettings(trials=2), Kept.parse("failures")
    view = evaluate(run, settings, say=lambda words: None, kept=kept)
    assert view.trials["solved"].to_pylist() == [True, False] * 2
    assert kept_trials(view.path) == [1, 3]
    failed = episode_file.read(path_of(view.path, 1), view.origin)
    results = view.actions_of(1)["result"].to_pylist()
    assert [str(span.outcome.result) for span in failed.actions] == results
    assert results == ["success", "jammed"]
    (trial,) = view.trials.slice(2, 1).to_pylist()
    rows = view.actions_of(2).to_pylist()
    again = resimulate(view, trial, rows)
    assert again.inserted
    lasted = [span.end - span.start for span in again.actions]
    assert lasted == pytest.approx([row["sim_seconds"] for row in rows])
