"""A recording to hand on: complete trees in one file, without their states."""

from collections.abc import Iterable
from pathlib import Path

import pyarrow as pa

from prospect_mj import tables
from prospect_mj.errors import RecordingError
from prospect_mj.recording import files
from prospect_mj.recording import key as keys
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.node_table import tabulated
from prospect_mj.recording.tree import OutcomeTree
from prospect_mj.storage import replace_file


def pack(trees: Iterable[OutcomeTree], key: RecordingKey, path: Path) -> int:
    """Write trees without their states, to be stepped but not grown.

    Args:
        trees: what to write.
        key: what they are of.
        path: a folder that is free.

    Returns:
        Number of trees.

    Raises:
        RecordingError: if there is no tree.
    """
    parts = [tabulated(tree, states=False) for tree in trees]
    if not parts:
        raise RecordingError("there is no complete tree to pack")
    path.mkdir(parents=True, exist_ok=True)
    content = tables.parquet(pa.concat_tables(parts), key.digest, compression="zstd")
    replace_file(path / files.PACKED, content)
    replace_file(path / keys.NAME, key.as_yaml())
    return len(parts)
