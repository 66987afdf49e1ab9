"""What numba has kept on disk of compiled code."""

from pathlib import Path


def kept_functions(dispatcher):
    """Names of what is kept beside a compiled function, one for each signature."""
    folder = Path(dispatcher.stats.cache_path)
    return sorted(path.stem.rpartition(".")[0] for path in folder.glob("*.nbc"))
