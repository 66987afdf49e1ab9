"""A jar as the camera sees it: assets/jar.obj and its texture assets/jar.png.

Those are of the default jar; what other jars look like is made when they are.
"""

import itertools
from pathlib import Path

import cv2
import numpy as np
import trimesh

from prospect_mj.sim.props import Jar

BEVEL = 0.0015
"""Of base, rim and lid [m]."""
SECTIONS = 96
"""Round the jar."""
ROWS = 340
"""Of the texture, from end to end [pixels]."""
BODY, LABEL, LID = (158, 107, 56), (200, 195, 170), (235, 235, 225)
"""RGB."""


def profile(jar: Jar) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Outline of the jar as (radius, z) segments from base to lid, (m, m)."""
    low, high, rim = -jar.length / 2, jar.length / 2, jar.length / 2 - jar.lid_length
    points = [(0.0, low), (jar.body_radius - BEVEL, low)]
    points += [(jar.body_radius, low + BEVEL), (jar.body_radius, rim)]
    points += [(jar.lid_radius - BEVEL, rim), (jar.lid_radius, rim + BEVEL)]
    points += [(jar.lid_radius, high - BEVEL), (jar.lid_radius - BEVEL, high)]
    if jar.recess is not None:
        end = high - jar.recess.depth
        points += [(jar.recess.radius, high), (jar.recess.radius, end), (0.0, end)]
    else:
        points += [(0.0, high)]
    return list(itertools.pairwise(points))


def mesh(jar: Jar) -> trimesh.Trimesh:
    """The lathe: one strip a segment, so that edges stay sharp when shaded."""
    strips = []
    for start, end in profile(jar):
        strip = trimesh.creation.revolve(np.array([start, end]), sections=SECTIONS)
        strips.append(strip)
    whole = trimesh.util.concatenate(strips)
    angle = np.arctan2(whole.vertices[:, 1], whole.vertices[:, 0])
    along = whole.vertices[:, 2] / jar.length + 0.5
    uv = np.column_stack([angle / (2 * np.pi) + 0.5, np.clip(along, 0.002, 0.998)])
    whole.visual = trimesh.visual.TextureVisuals(uv=uv)
    return whole


def texture(jar: Jar) -> np.ndarray:
    """Colour of each ring of the jar, (ROWS, 8, 3) uint8 RGB, lid first."""
    z = (0.5 - (np.arange(ROWS) + 0.5) / ROWS) * jar.length
    rows = np.tile(np.array(BODY, np.uint8), (ROWS, 1))
    rows[(z > jar.label[0]) & (z < jar.label[1])] = LABEL
    rows[z > jar.length / 2 - jar.lid_length] = LID
    return np.repeat(rows[:, None, :], 8, axis=1)


def obj(jar: Jar) -> bytes:
    """The mesh as a Wavefront file."""
    text = trimesh.exchange.obj.export_obj(
        mesh(jar), include_normals=True, digits=6, write_texture=False, header=None
    )
    lines = [line for line in text.splitlines() if not line.startswith(("mtl", "usem"))]
    return ("\n".join(lines) + "\n").encode()


def png(jar: Jar) -> bytes:
    """The texture as a PNG file."""
    return cv2.imencode(".png", texture(jar)[:, :, ::-1])[1].tobytes()


def write(folder: Path) -> None:
    """Write both files of the default jar into `folder`."""
    (folder / "jar.obj").write_bytes(obj(Jar()))
    (folder / "jar.png").write_bytes(png(Jar()))
