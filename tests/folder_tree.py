"""All that is in a folder, to be compared with what is there later."""


def tree(folder):
    """Content by path, None for a folder."""
    return {
        str(path): path.read_bytes() if path.is_file() else None
        for path in folder.rglob("*")
    }
