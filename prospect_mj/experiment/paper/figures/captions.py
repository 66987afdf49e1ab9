"""What the figures are called; a PNG and a Parquet file have a figure's name."""

FIGURE_5A = "figure_5a"
FIGURE_5B = "figure_5b"
FIGURE_6A = "figure_6a"
FIGURE_6B = "figure_6b"
LIVE = "live"

FIGURES = {
    FIGURE_5A: "Actions per trial without a dominant hand",
    FIGURE_5B: "Actions per trial with a dominant hand",
    FIGURE_6A: "Strategies in easy trials",
    FIGURE_6B: "Strategies in difficult trials",
}
"""The paper's figures, each with its title."""
TITLES = {**FIGURES, LIVE: "Live physics against recorded"}
"""All figures, each with its title."""


def words(name: str) -> str:
    """A figure's name as it is written in a sentence."""
    return name.replace("_", " ")
