"""What categories do to late and early corrections: learners with and without them.

Three things can be told of a grasp: which hand holds the jar (the two bits), the
category of the grasp as well, or, as a bound on what any haptic category could do, the
very end that is held. Failed actions are suppressed, and the right hand was made
dominant. What is measured is `development.measures`.
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.agent.haptics import n_features, n_haptic
from prospect_mj.agent.settings import (
    AnyLearnerSettings,
    DiscoverySettings,
    LearnerSettings,
)
from prospect_mj.experiment.development.haptics.grasp import BODY, LID
from prospect_mj.experiment.development.haptics.recorded import category_of_nodes
from prospect_mj.experiment.development.measures.development import (
    Development,
    difficult,
)
from prospect_mj.experiment.development.measures.measures import MEASURES, order
from prospect_mj.experiment.paper.measures.bootstrap import band
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.populations.world import World
from prospect_mj.experiment.run.learning_curve import BLOCK
from prospect_mj.haptics import TrajectoryModels
from prospect_mj.recording.recording import Recording

SHARES = pa.schema(
    {
        "learner": pa.string(),
        "told": pa.string(),
        "strategy": pa.string(),
        "trial": pa.int32(),
        "share": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
    }
)
"""Share of difficult trials [1] in a set of ten that begins with a trial."""
MEASURED = pa.schema(
    {
        "learner": pa.string(),
        "told": pa.string(),
        "runs": pa.int32(),
        "measure": pa.string(),
        "estimate": pa.float64(),
        "low": pa.float64(),
        "high": pa.float64(),
        "lacking": pa.float64(),
    }
)
"""A measure by its name, `ORDER` among them, with its 95 % interval; lacking: share of
the resamples without it."""

LINEAR, DISCOVERY = "linear", "discovery"
LEARNERS = LINEAR, DISCOVERY
BITS, CATEGORY, END = TOLD = "two bits", "category", "end"
ORDER = "order"
"""Share of the resamples in which late corrections are gone before early ones [1]."""

SCENARIO = Scenario(trials=1000, pretrain=400, dominant="right")

Learn = Callable[[World, Scenario, PopulationSettings], Population]
"""Lets a population learn, or reads it where it was kept."""


class Effect(NamedTuple):
    """What learners came to."""

    shares: pa.Table
    """Under `SHARES`."""
    measures: pa.Table
    """Under `MEASURED`."""


def effect(
    recording: Recording,
    models: TrajectoryModels,
    runs: int,
    seed: int,
    learn: Learn,
    tell: Callable[[str], object],
) -> Effect:
    """Let all learners learn, and measure.

    Args:
        recording: outcomes and what was felt.
        models: the categories.
        runs: of each learner.
        seed: of learners and resamples.
        learn: lets a population learn.
        tell: takes a line as each population is there.
    """
    shares, measures = [], []
    for told, world in worlds(recording, models).items():
        for learner in LEARNERS:
            settings = PopulationSettings(
                runs=runs,
                seed=seed,
                learner=_settings(learner, world.categories),
                failed_actions="suppressed",
                categories=world.categories,
            )
            population = learn(world, SCENARIO, settings)
            tell(f"haptics: {learner} told of {told}, {runs} runs")
            names = {"learner": learner, "told": told}
            taken = Development.of(population, np.random.default_rng(seed))
            shares += [names | row for row in _shares(taken)]
            measures += [names | {"runs": runs} | row for row in _measures(taken)]
    return Effect(
        pa.Table.from_pylist(shares, schema=SHARES),
        pa.Table.from_pylist(measures, schema=MEASURED),
    )


def worlds(recording: Recording, models: TrajectoryModels) -> dict[str, World]:
    """The same outcomes, by what is told of a grasp."""
    category = category_of_nodes(recording, models)
    return {
        BITS: World(recording),
        CATEGORY: World(recording, len(models), category),
        END: World(recording, len((BODY, LID)), ends_of_nodes(recording)),
    }


def ends_of_nodes(recording: Recording) -> NDArray[np.int64]:
    """(n,): BODY or LID, the end that is held in each node; BODY where none is."""
    shown, holding = recording.presentations, recording.nodes.holding
    own = np.arange(len(holding))
    lid = shown.lid[np.searchsorted(shown.root, own, side="right") - 1]
    return np.where(holding == lid, LID, BODY)


def _settings(learner: str, categories: int) -> AnyLearnerSettings:
    if learner == LINEAR:
        return LearnerSettings(n_features=n_features(categories))
    return DiscoverySettings(n_haptic=n_haptic(categories))


def _measures(taken: Development) -> Iterator[dict[str, object]]:
    for measure in MEASURES:
        yield {"measure": measure.name} | measure.estimate(taken)._asdict()
    share = order(taken)
    bounds = {"low": np.nan, "high": np.nan, "lacking": 0.0}
    yield {"measure": ORDER, "estimate": share} | bounds


def _shares(taken: Development) -> Iterator[dict[str, object]]:
    switch = taken.mean.switch
    for strategy in Strategy:
        low, high = band(difficult(taken.resampled, strategy))
        shares = difficult(taken.mean, strategy)[0]
        for number, values in enumerate(zip(shares, low, high, strict=True)):
            trial = {
                "strategy": strategy.name.lower(),
                "trial": BLOCK * (switch + number),
            }
            yield trial | dict(zip(("share", "low", "high"), values, strict=True))
