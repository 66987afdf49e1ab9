"""MuJoCo's visible geoms as Rerun's primitives and meshes, which are logged once."""

from collections.abc import Iterator

import mujoco
import numpy as np
import rerun as rr

ROOT = "scene"
"""Path above all bodies."""

_GEOM = mujoco.mjtGeom
_COLLISION_GROUP = 3
_FLOOR = (2.0, 2.0, 0.005)
"""Half sizes in place of an infinite plane [m]."""


def entity(model: mujoco.MjModel, body: int) -> str:
    """The path of a body's entity."""
    return f"{ROOT}/{model.body(body).name.rstrip('/')}"


def shapes(model: mujoco.MjModel) -> Iterator[tuple[str, rr.AsComponents]]:
    """Every body's shape, batched by kind, under its entity's path.

    Args:
        model: the scene; no body of it has more than one mesh.
    """
    for body in range(model.nbody):
        geoms = np.flatnonzero(
            (model.geom_bodyid == body) & (model.geom_group != _COLLISION_GROUP)
        )
        for kind in sorted({int(model.geom_type[g]) for g in geoms}):
            of_kind = [int(g) for g in geoms if model.geom_type[g] == kind]
            name = _GEOM(kind).name.removeprefix("mjGEOM_").lower()
            path = f"{entity(model, body)}/{name}"
            yield path, _batch(model, _GEOM(kind), of_kind)


def _batch(model: mujoco.MjModel, kind: _GEOM, geoms: list[int]) -> rr.AsComponents:
    sizes, places = model.geom_size[geoms], model.geom_pos[geoms]
    colours = [_colour(model, geom) for geom in geoms]
    turned = {"quaternions": np.roll(model.geom_quat[geoms], -1, axis=1)}
    look = {"colors": colours, "fill_mode": "solid"}
    match kind:
        case _GEOM.mjGEOM_BOX:
            return rr.Boxes3D(half_sizes=sizes, centers=places, **turned, **look)
        case _GEOM.mjGEOM_PLANE:
            below = places - [0, 0, _FLOOR[2]]
            half = np.tile(_FLOOR, (len(geoms), 1))
            return rr.Boxes3D(half_sizes=half, centers=below, **turned, **look)
        case _GEOM.mjGEOM_SPHERE:
            radii = np.repeat(sizes[:, :1], 3, axis=1)
            return rr.Ellipsoids3D(half_sizes=radii, centers=places, **turned, **look)
        case _GEOM.mjGEOM_CYLINDER:
            lengths, radii = 2 * sizes[:, 1], sizes[:, 0]
            return rr.Cylinders3D(
                lengths=lengths, radii=radii, centers=places, **turned, **look
            )
        case _GEOM.mjGEOM_CAPSULE:
            return _capsules(sizes, places, model.geom_quat[geoms], turned | look)
        case _GEOM.mjGEOM_MESH:
            (geom,) = geoms
            return _mesh(model, geom)
    raise AssertionError(f"the scene has no geoms of kind {kind.name}")


def _capsules(
    sizes: np.ndarray, places: np.ndarray, turns: np.ndarray, look: dict[str, object]
) -> rr.Capsules3D:
    """Rerun's capsules begin at their origin, MuJoCo's have it in the middle."""
    starts = []
    for size, place, turn in zip(sizes, places, turns, strict=True):
        axis = np.empty(3)
        mujoco.mju_rotVecQuat(axis, np.array([0.0, 0.0, 1.0]), turn)
        starts.append(place - size[1] * axis)
    lengths = 2 * sizes[:, 1]
    return rr.Capsules3D(
        lengths=lengths, radii=sizes[:, 0], translations=starts, **look
    )


def _mesh(model: mujoco.MjModel, geom: int) -> rr.Mesh3D:
    """A mesh with its texture, each corner of a face on its own."""
    mesh = int(model.geom_dataid[geom])
    first, n = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
    faces = slice(first, first + n)
    corners, normals, coordinates = (
        numbers[faces].ravel() + start[mesh]
        for numbers, start in (
            (model.mesh_face, model.mesh_vertadr),
            (model.mesh_facenormal, model.mesh_normaladr),
            (model.mesh_facetexcoord, model.mesh_texcoordadr),
        )
    )
    turn = model.geom_quat[geom]
    places = np.array([_turned(v, turn) for v in model.mesh_vert[corners]])
    return rr.Mesh3D(
        vertex_positions=places + model.geom_pos[geom],
        vertex_normals=[_turned(v, turn) for v in model.mesh_normal[normals]],
        triangle_indices=np.arange(3 * n).reshape(n, 3),
        vertex_texcoords=model.mesh_texcoord[coordinates],
        albedo_texture=_texture(model, geom),
    )


def _texture(model: mujoco.MjModel, geom: int) -> np.ndarray:
    """The picture on a geom's material (rows, columns, 3)."""
    material = int(model.geom_matid[geom])
    role = mujoco.mjtTextureRole.mjTEXROLE_RGB
    number = int(model.mat_texid[material, role])
    rows, columns = int(model.tex_height[number]), int(model.tex_width[number])
    start, channels = int(model.tex_adr[number]), int(model.tex_nchannel[number])
    pixels = model.tex_data[start : start + rows * columns * channels]
    return pixels.reshape(rows, columns, channels)[:, :, :3]


def _turned(vector: np.ndarray, turn: np.ndarray) -> np.ndarray:
    result = np.empty(3)
    mujoco.mju_rotVecQuat(result, vector.astype(float), turn)
    return result


def _colour(model: mujoco.MjModel, geom: int) -> np.ndarray:
    """(4,) RGBA in 0..1: a material's is stronger than a geom's own."""
    material = int(model.geom_matid[geom])
    return model.geom_rgba[geom] if material < 0 else model.mat_rgba[material]
