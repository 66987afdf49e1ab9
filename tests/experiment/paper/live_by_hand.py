"""Folders of live runs made by hand, of which everything is known."""

from prospect_mj.experiment.run import config_file, fingerprint
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.records import TrialRecord, trial_table
from prospect_mj.experiment.run.run_files import CONFIG, TRIALS
from prospect_mj.tables import parquet


def live_run(path, n_actions, trials=None, **settings):
    """A run on live physics, in so many trials of which it took these actions."""
    trials = len(n_actions) if trials is None else trials
    config = TrainConfig(trials=trials, **settings)
    path.mkdir(parents=True)
    config_file.write(path / CONFIG, config)
    rows = [
        TrialRecord(trial, "left", False, "found", int(taken), bool(taken < 10), 5.0)
        for trial, taken in enumerate(n_actions)
    ]
    origin = fingerprint.origin(config)
    (path / TRIALS).write_bytes(parquet(trial_table(rows), origin))


def live_runs(folder, n_actions, **settings):
    """A run for each row (runs, trials), with its number as its seed."""
    for seed, row in enumerate(n_actions):
        live_run(folder / f"seed-{seed:04d}", row, seed=seed, **settings)
