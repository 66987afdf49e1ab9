"""What follows from states is what was there."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest

from prospect_mj.episodes.episode import States
from prospect_mj.errors import EpisodeError
from prospect_mj.replay.playback import hand_path, model_of, play
from prospect_mj.robot.names import grasp_site

pytestmark = pytest.mark.gl


@pytest.fixture(scope="module")
def played(late):
    model = model_of(late)
    return model, play(late, model)


def test_the_jar_ends_upright_in_the_receptacle(late, played):
    model, frames = played
    jar = model.body("jar/").id
    well = late.scene.props.well
    x, y, z = frames.positions[-1, jar]
    assert np.hypot(x - well.position[0], y - well.position[1]) < 0.01
    assert z < frames.positions[0, jar, 2]


def test_contacts_carry_the_jar_where_it_rests(late, played):
    _, frames = played
    weight = 9.81 * late.scene.props.jar.mass
    for place in (0, -1):
        total = frames.contacts[place].forces.sum(axis=0)
        np.testing.assert_allclose(total, [0, 0, weight], atol=0.1 * weight)


def test_fingers_press_while_they_hold(late, played):
    _, frames = played
    start = late.states.times[0]
    swap = late.actions[2]
    held = (frames.times > late.actions[0].end - start) & (
        frames.times < swap.start - start
    )
    assert frames.touch_forces[held, 1].min() > 1
    assert frames.touch_forces[held, 0].max() == 0


def test_a_planned_path_begins_at_the_hand_and_ends_elsewhere(late, played):
    model, frames = played
    path = late.actions[0].paths[0]
    places = hand_path(model, path)
    at = np.searchsorted(frames.times, path.start - late.states.times[0])
    site = model.site(grasp_site(path.side))
    wrist, turned = site.bodyid[0], np.empty(3)
    mujoco.mju_rotVecQuat(turned, site.pos, frames.quaternions[at, wrist])
    hand = frames.positions[at, wrist] + turned
    assert np.linalg.norm(places[0] - hand) < 0.01
    assert np.linalg.norm(places[-1] - places[0]) > 0.1


def test_states_of_another_model_are_refused(late):
    states = States(late.states.times, late.states.rows[:, :-1])
    with pytest.raises(EpisodeError, match="recorded with another model"):
        model_of(replace(late, states=states))
