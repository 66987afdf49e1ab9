"""The comparison of the paper's learner with its rivals on the same task."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import process_time

import numpy as np
import pyarrow as pa

from prospect_mj.checks import check_integer
from prospect_mj.experiment.development.rivals import learning
from prospect_mj.experiment.development.rivals.deep.agents import (
    DeepRun,
    check_installed,
)
from prospect_mj.experiment.development.rivals.deep.runs import DeepStore
from prospect_mj.experiment.development.rivals.learning import Runs
from prospect_mj.experiment.development.rivals.planner import model_errors, prices
from prospect_mj.experiment.development.rivals.settings import (
    DEEP,
    MASKED,
    RivalSettings,
)
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.experiment.populations.population import run_population
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.recording.recording import Recording

MAX_ACTIONS = PopulationSettings.max_actions
FOLDER = "rivals"
"""Of the deep learners' runs, in that of the study."""

_MOST_JOBS = 1024


@dataclass(frozen=True)
class RivalResults:
    """What came out."""

    settings: RivalSettings
    learning: pa.Table
    """Under `learning.LEARNING`: trials until near-optimal, a row for each learner."""
    curves: pa.Table
    """Under `learning.CURVES`: mean actions by trial."""
    prices: pa.Table
    """Under `planner.prices.PRICES`: what a decision costs."""
    errors: pa.Table
    """Under `planner.model_errors.ERRORS`: backward chaining with wrong beliefs."""
    live_errors: pa.Table
    """Under `planner.model_errors.LIVE`: search in slightly wrong physics."""

    @property
    def tables(self) -> dict[str, pa.Table]:
        """All of them, by the name of their file."""
        return {
            "rivals_learning": self.learning,
            "rivals_curves": self.curves,
            "rivals_prices": self.prices,
            "rivals_errors": self.errors,
            "rivals_live_errors": self.live_errors,
        }


def run(
    folder: Path,
    settings: RivalSettings | None = None,
    recording: Path | None = None,
    jobs: int = 1,
    tell: Callable[[str], None] = print,
) -> RivalResults:
    """Compare; runs of deep learners that are in the folder already are read.

    Args:
        folder: of the study; deep learners' runs are kept in `rivals` in it.
        settings: what is compared.
        recording: folder of the recording; None is the one that comes with the package.
        jobs: processes of deep learners side by side, and threads of the others.
        tell: takes a line for people now and then.

    Raises:
        MissingPackage: if a deep learner is wanted and its library is not installed.
        RecordingError: if the recording can't be had.
        RenderingUnavailable: if live physics is to be searched without OpenGL.
        RunFolderError: if a kept run is damaged.
        ChildProcessError: if a process of a deep learner was killed.
    """
    settings = RivalSettings() if settings is None else settings
    check_integer("jobs", jobs, 1, _MOST_JOBS)
    if settings.deep:
        check_installed()
    outcomes = Recording.load(recording)
    priced = prices.prices(outcomes, settings, MAX_ACTIONS)
    believed = model_errors.believed(outcomes, settings, MAX_ACTIONS)
    tell("planner: searching physics that is slightly wrong")
    searched = model_errors.searched(outcomes, settings, MAX_ACTIONS)
    learners = _learners(folder, settings, recording, outcomes, jobs, tell)
    how = learners, settings.deep_runs, settings.seed
    learned = learning.learning(*how), learning.curves(*how)
    return RivalResults(settings, *learned, priced, believed, searched)


def _learners(
    folder: Path,
    settings: RivalSettings,
    path: Path | None,
    recording: Recording,
    jobs: int,
    tell: Callable[[str], None],
) -> dict[str, Runs]:
    """What every learner did, by name, in the order of the settings."""
    deep = _deep(folder, settings, path, recording, jobs, tell)
    return {
        agent: deep[agent]
        if agent in DEEP
        else _linear(agent, settings, recording, jobs)
        for agent in settings.agents
    }


def _linear(
    agent: str, settings: RivalSettings, recording: Recording, jobs: int
) -> Runs:
    mode = "productive" if agent in MASKED else "none"
    learners = PopulationSettings(
        runs=settings.linear_runs, seed=settings.seed, supervisor=mode
    )
    scenario, began = Scenario(settings.deep_trials), process_time()
    learned = run_population(recording, scenario, learners, jobs)
    seconds = (process_time() - began) / settings.linear_runs
    return Runs(learned.n_actions, seconds)


def _deep(
    folder: Path,
    settings: RivalSettings,
    path: Path | None,
    recording: Recording,
    jobs: int,
    tell: Callable[[str], None],
) -> dict[str, Runs]:
    if not settings.deep:
        return {}
    store = DeepStore(folder / FOLDER, recording_digest(recording))
    runs = deep_runs(settings, path)
    learned = iter(store.get(runs, jobs, tell))
    done: dict[str, Runs] = {}
    for agent in settings.deep:
        of_agent = [next(learned) for _ in range(settings.deep_runs)]
        seconds = float(np.mean([one.seconds for one in of_agent]))
        done[agent] = Runs(np.stack([one.n_actions for one in of_agent]), seconds)
    return done


def deep_runs(settings: RivalSettings, recording: Path | None) -> list[DeepRun]:
    """Every run of the deep learners, one learner after the other.

    Run k of a learner is the same in a comparison of any size.
    """
    return [
        DeepRun(agent, settings.deep_trials, _seed(settings, agent, number), recording)
        for agent in settings.deep
        for number in range(settings.deep_runs)
    ]


def _seed(settings: RivalSettings, agent: str, number: int) -> int:
    key = DEEP.index(agent), number
    sequence = np.random.SeedSequence(settings.seed, spawn_key=key)
    return int(sequence.generate_state(1)[0])
