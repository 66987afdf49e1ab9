"""The command that makes the numbers of a part."""

from dataclasses import fields

from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import Part, StudySettings


def command(results: Results, *parts: Part) -> str:
    """How to make what was just told, in a folder of one's own or in the same one.

    Args:
        results: of the study.
        parts: that it is from.
    """
    settings, usual = results.settings, StudySettings()
    given = [
        f"--{field.name.replace('_', '-')} {getattr(settings, field.name)}"
        for field in fields(settings)
        if getattr(settings, field.name) != getattr(usual, field.name)
    ]
    made = [part for part in parts if part in results.extent.parts]
    words = " ".join(["prospect development", "--parts", *made, *given])
    return f"Made by `{words}`."
