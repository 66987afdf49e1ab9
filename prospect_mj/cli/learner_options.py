"""The options of a learner: its name, and the parameters that this learner has.

`--learner table --learner.step-size 0.2` names a learner and then its parameters. As
each has others, the name is looked for before the options are parsed.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Annotated, Any, Literal

from tyro.conf import arg
from tyro.constructors import (
    ConstructorRegistry,
    StructConstructorSpec,
    StructFieldSpec,
    StructTypeInfo,
)

from prospect_mj.agent.learners import NAMES, SETTINGS, with_categories
from prospect_mj.agent.settings import AnyLearnerSettings
from prospect_mj.cli.haptic_option import OptionalModels
from prospect_mj.experiment.run.config import TrainConfig

OPTION = "--learner"

_FIXED = ("n_actions", "n_features", "n_haptic", "name")
"""Settings that are no options of their own: the task fixes the sizes."""
_Name = Literal[NAMES]
_MEANING = (
    "Which learner: the paper's, the same with replayed experience, a table that is "
    "told the orientation, or one that discovers features. The options below are its "
    "own; --learner NAME --help shows those of another."
)


def named_learner(argv: Sequence[str]) -> str | None:
    """The learner that a command line names last; None: none that there is."""
    named = None
    for word, following in pairwise([*argv, ""]):
        option, _, value = word.partition("=")
        if option == OPTION:
            named = value or following
    return named if named in SETTINGS else None


def with_learner(config: TrainConfig, argv: Sequence[str]) -> TrainConfig:
    """The defaults that the options of a command line are beside.

    Args:
        config: defaults where no other learner is named.
        argv: the command line.
    """
    name = named_learner(argv)
    if name in (None, config.learner.name):
        return config
    learner = with_categories(SETTINGS[name](), config.categories)
    return replace(config, learner=learner)


def learner_registry() -> ConstructorRegistry:
    """The rules of tyro for a run's learner: not commands of their own, but options."""
    registry = ConstructorRegistry()
    under_way: list[object] = []

    @registry.struct_rule
    def offer(info: StructTypeInfo) -> StructConstructorSpec | None:
        kind = info.type
        if kind in under_way or kind not in (TrainConfig, *SETTINGS.values()):
            return None
        under_way.append(kind)
        try:
            # By the other rules, as this one does nothing for a type under way.
            usual = ConstructorRegistry.get_struct_spec(info)
        finally:
            under_way.pop()
        return _run(usual) if kind is TrainConfig else _learner(usual)

    return registry


def _run(usual: StructConstructorSpec) -> StructConstructorSpec:
    """Options of a run whose learner is of the kind that the default has.

    The learner knows as many haptic states as there are by the run's haptic models.
    """
    defaults = {field.name: field.default for field in usual.fields}
    kinds = {"learner": type(defaults["learner"]), "haptic_models": OptionalModels}
    fields = (replace(f, type=kinds.get(f.name, f.type)) for f in usual.fields)

    def instantiate(**given: Any) -> TrainConfig:  # noqa: ANN401
        models = given["haptic_models"]
        categories = 0 if models is None else len(models)
        learner = with_categories(given["learner"], categories)
        return TrainConfig(**{**given, "learner": learner})

    return replace(usual, instantiate=instantiate, fields=tuple(fields))


def _learner(usual: StructConstructorSpec) -> StructConstructorSpec:
    """Options for the name and the parameters of a learner."""
    parameters = tuple(field for field in usual.fields if field.name not in _FIXED)
    default = next(field.default for field in usual.fields if field.name == "name")
    name = StructFieldSpec(
        "name", Annotated[_Name, arg(name="")], default, helptext=_MEANING
    )

    def instantiate(**given: Any) -> AnyLearnerSettings:  # noqa: ANN401
        return SETTINGS[given["name"]](**given)

    return StructConstructorSpec(instantiate=instantiate, fields=(name, *parameters))
