"""What is in an .rrd file."""

import subprocess

import numpy as np
import pyarrow as pa
from rerun.chunk import RrdReader

from prospect_mj.replay import viewer
from prospect_mj.replay.timeline import TIMELINE


def rerun(*arguments):
    return subprocess.run(
        [viewer.program(), *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
    )


class Recording:
    def __init__(self, path):
        self.chunks = list(RrdReader(path).stream())

    @property
    def entities(self):
        return {chunk.entity_path for chunk in self.chunks}

    def column(self, entity, name):
        """Times [s] and lists of a component that changes."""
        batches = self._batches(entity, name, static=False)
        times = [np.asarray(batch[TIMELINE].cast(pa.int64())) for batch in batches]
        values = [value for batch in batches for value in batch[name].to_pylist()]
        return np.concatenate(times) / 1e9, values

    def static(self, entity, name):
        (batch,) = self._batches(entity, name, static=True)
        return batch[name].to_pylist()[0]

    def _batches(self, entity, name, static):
        return [
            batch
            for chunk in self.chunks
            if chunk.entity_path == entity and chunk.is_static == static
            if name in (batch := chunk.to_record_batch()).schema.names
        ]
