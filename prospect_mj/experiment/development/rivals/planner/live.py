"""Searches in live physics, which take their time, read where they were made before."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pyarrow as pa

from prospect_mj.experiment.development.rivals import kept
from prospect_mj.experiment.development.rivals.planner.prices import (
    PRICES,
    live_prices,
)
from prospect_mj.experiment.development.rivals.planner.wrong_physics import (
    WRONG,
    searched,
)
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording

_CODE = "experiment/development/rivals/planner/*.py", "recording/*.py"


@dataclass(frozen=True)
class LiveSearches:
    """A folder of what they came to."""

    folder: Path
    """Where it is kept; made when there is something to keep."""
    recording: Recording
    """The world, and its presentations."""
    settings: RivalSettings
    max_actions: int
    """What a trial takes that was not solved."""
    tell: Callable[[str], object]
    """Takes a line before each search that is made."""

    def prices(self) -> pa.Table:
        """What decisions cost in live physics, under `prices.PRICES`.

        Raises:
            RenderingUnavailable: if there is no OpenGL and something is to be searched.
            RunFolderError: if the folder can't be made, or what was kept is damaged.
        """
        settings = self.settings
        if not settings.live_presentations:
            return PRICES.empty_table()

        def make() -> pa.Table:
            self.tell("planner: searching live physics")
            return live_prices(self.recording, settings)

        decides = {"presentations": settings.live_presentations}
        return self._made_once("live-prices", decides, make, PRICES)

    def wrong(self) -> pa.Table:
        """What search in slightly wrong physics comes to, under `wrong_physics.WRONG`.

        Raises:
            RenderingUnavailable, RunFolderError: as `prices`.
        """
        settings = self.settings
        if not settings.live_errors:
            return WRONG.empty_table()

        def make() -> pa.Table:
            self.tell("planner: searching physics that is slightly wrong")
            return searched(self.recording, settings, self.max_actions)

        decides = {"errors": settings.live_errors, "max_actions": self.max_actions}
        return self._made_once("live-errors", decides, make, WRONG)

    def _made_once(
        self,
        name: str,
        own: dict[str, object],
        make: Callable[[], pa.Table],
        schema: pa.Schema,
    ) -> pa.Table:
        decides = own | {
            "depth": self.settings.depth,
            "recording": recording_digest(self.recording),
            "physics": RecordingKey.present(self.recording.key.config).digest,
            "code": kept.code(_CODE),
        }
        return kept.made_once(self.folder, name, decides, make, schema)
