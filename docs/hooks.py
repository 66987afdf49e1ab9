"""What the site does beyond Markdown: formulas as MathML, and the commands' help.

Both need nothing from elsewhere, neither while the site is built nor when it is read.
"""

import html
import os
import re
import subprocess
import sys

from latex2mathml.converter import convert
from mkdocs.config.defaults import MkDocsConfig

_RUN = "import sys; from prospect_mj.cli.app import main; sys.exit(main())"
_HELP = re.compile(r"```sh\n(prospect(?: [a-z-]+)? --help)\n```\n")


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Render fenced blocks of kind `math`, which forges render as formulas, too."""
    fence = {"name": "math", "class": "math", "format": _formula}
    config.mdx_configs["pymdownx.superfences"] = {"custom_fences": [fence]}
    return config


def on_page_markdown(markdown: str, **_: object) -> str:
    """Put what a command says of itself below a block that asks for it."""
    return _HELP.sub(lambda found: f"{found[0]}\n{_help(found[1])}\n", markdown)


def _formula(source: str, *_: object, **__: object) -> str:
    """LaTeX as MathML, a formula for each block of lines."""
    parts = re.split(r"\n\s*\n", source.strip())
    formulas = [convert(part, display="block") for part in parts]
    for part, formula in zip(parts, formulas, strict=True):
        if "\\" in formula:
            raise ValueError(f"a formula has something that can't be set: {part}")
    return "\n".join(f'<div class="math">{formula}</div>' for formula in formulas)


def _help(command: str) -> str:
    """What a command prints, as a block that is not highlighted."""
    done = subprocess.run(
        [sys.executable, "-c", _RUN, *command.split()[1:]],
        capture_output=True,
        text=True,
        check=True,
        env=os.environ | {"COLUMNS": "88", "NO_COLOR": "1", "PYTHONUTF8": "1"},
    )
    return f'<pre class="help"><code>{html.escape(done.stdout.strip())}</code></pre>\n'
