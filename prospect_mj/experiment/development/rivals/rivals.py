"""The comparison of the paper's learner with its rivals on the same task."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa

from prospect_mj.checks import check_integer
from prospect_mj.experiment.development.rivals import learning
from prospect_mj.experiment.development.rivals.deep.agents import (
    DeepRun,
    check_installed,
)
from prospect_mj.experiment.development.rivals.deep.runs import DeepStore
from prospect_mj.experiment.development.rivals.kept import FOLDER
from prospect_mj.experiment.development.rivals.learning import Runs
from prospect_mj.experiment.development.rivals.planner import model_errors, prices
from prospect_mj.experiment.development.rivals.planner.live import LiveSearches
from prospect_mj.experiment.development.rivals.settings import (
    DEEP,
    MASKED,
    RivalSettings,
)
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.experiment.populations.population import MOST_JOBS
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.populations.store import Kept, Store
from prospect_mj.recording.recording import Recording

MAX_ACTIONS = PopulationSettings.max_actions
POPULATIONS = "populations"
"""Of linear learners, in the folder of a comparison on its own."""

Learn = Callable[[Scenario, PopulationSettings], Kept]
"""Lets a population learn in the world of the comparison, or reads it."""


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
    """Under `planner.wrong_physics.WRONG`: search in slightly wrong physics."""

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
    recording: Recording,
    settings: RivalSettings | None = None,
    path: Path | None = None,
    jobs: int = 1,
    tell: Callable[[str], object] = print,
    learn: Learn | None = None,
) -> RivalResults:
    """Compare; what took time and is kept in the folder is read.

    Args:
        folder: of the study; runs of deep learners and searches in live physics are
            kept in `rivals` in it.
        recording: the outcomes.
        settings: what is compared.
        path: folder of the recording, for the processes of deep learners; None is the
            one that comes with the package.
        jobs: processes of deep learners, and threads of the others.
        tell: takes a line for people now and then.
        learn: of linear learners; None keeps them in `populations` of the folder.

    Raises:
        MissingPackage: if a deep learner's library is not installed.
        RenderingUnavailable: if live physics is to be searched without OpenGL.
        RunFolderError: if something that was kept is damaged.
        ChildProcessError: if a process of a deep learner was killed.
    """
    settings = RivalSettings() if settings is None else settings
    check_integer("jobs", jobs, 1, MOST_JOBS)
    if settings.deep:
        check_installed()
    live = LiveSearches(folder / FOLDER, recording, settings, MAX_ACTIONS, tell)
    priced = prices.prices(recording, settings, MAX_ACTIONS, live.prices())
    believed = model_errors.believed(recording, settings, MAX_ACTIONS)
    learn = Store(folder / POPULATIONS, recording, jobs).get if learn is None else learn
    runs = {agent: _linear(agent, settings, learn) for agent in settings.linear}
    runs |= _deep(folder, recording, settings, path, jobs, tell)
    learned = _learned(runs, settings)
    return RivalResults(settings, *learned, priced, believed, live.wrong())


def _learned(
    runs: Mapping[str, Runs], settings: RivalSettings
) -> tuple[pa.Table, pa.Table]:
    """Measures and curves of all learners, in the order of the settings."""
    learners = {agent: runs[agent] for agent in settings.agents}
    size = settings.deep_runs, settings.seed
    return learning.learning(learners, *size), learning.curves(learners, *size)


def _linear(agent: str, settings: RivalSettings, learn: Learn) -> Runs:
    learners = PopulationSettings(
        runs=settings.linear_runs,
        seed=settings.seed,
        supervisor="productive" if agent in MASKED else "none",
    )
    kept = learn(Scenario(settings.deep_trials), learners)
    # Of all threads together; none of them has had more of a processor.
    seconds = kept.seconds * kept.jobs / settings.linear_runs
    return Runs(kept.population.n_actions, seconds)


def _deep(
    folder: Path,
    recording: Recording,
    settings: RivalSettings,
    path: Path | None,
    jobs: int,
    tell: Callable[[str], object],
) -> dict[str, Runs]:
    """What each deep learner did."""
    if not settings.deep:
        return {}
    store = DeepStore(folder / FOLDER, recording_digest(recording))
    learned = iter(store.get(deep_runs(settings, path), jobs, tell))
    done = {}
    for agent in settings.deep:
        own = [next(learned) for _ in range(settings.deep_runs)]
        n_actions = np.stack([one.n_actions for one in own])
        done[agent] = Runs(n_actions, float(np.mean([one.seconds for one in own])))
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
