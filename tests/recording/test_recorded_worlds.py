"""The worlds: what decides their outcomes, and where their recordings are."""

import itertools
from dataclasses import replace

import pytest
from ideal_grower import content, grown_tree, key

from prospect_mj import paths
from prospect_mj.cli import app
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.tasks import load_recording
from prospect_mj.errors import InvalidChoice, RecordingError
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.recording import shipped
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.node_table import tabulated
from prospect_mj.recording.packing import Packing
from prospect_mj.recording.worlds import STANDARD, WORLDS, World
from prospect_mj.sim.camera import EyeSettings
from prospect_mj.sim.props import Jar, Lamp, Post, Props, Recess, Well


@pytest.fixture
def shelf(tmp_path, monkeypatch):
    """A folder of shipped recordings, empty at first."""
    monkeypatch.setattr(paths, "RECORDINGS", tmp_path / "recordings")
    return paths.RECORDINGS


def put(shelf, name, world):
    """Pack a small recording of a world under a name."""
    shelf.mkdir(exist_ok=True)
    trees = [tabulated(grown_tree(3, *tree)) for tree in (("left", 0), ("right", 0))]
    with Packing.open(shelf / name, shelf.parent / "growing") as packing:
        packing.write(trees, key(world=world))


def test_no_two_worlds_are_the_same():
    assert len({world.digest for world in WORLDS.values()}) == len(WORLDS)
    assert len({world.about for world in WORLDS.values()}) == len(WORLDS)


def test_the_standard_world_has_all_defaults():
    assert WORLDS[STANDARD].props == Props()
    assert WORLDS[STANDARD].noise_sd == EyeSettings().noise_sd
    for setting in (RecordingConfig, TrainConfig, PickPlaceSettings):
        assert setting().world == STANDARD


CHANGED = [
    World("", noise_sd=2.5),
    World("", Props(jar=Jar(lid_radius=0.046))),
    World("", Props(jar=Jar(recess=Recess()))),
    World("", Props(jar=Jar(recess=Recess(depth=0.036)))),
    World("", Props(well=Well(post=Post()))),
    World("", Props(well=Well(post=Post(radius=0.011)))),
    World("", Props(lamp=Lamp(position=(0.5, 0.8, 1.21)))),
    World("", Props(lamp=Lamp(stand=(1.0, 0.67)))),
]


def test_all_that_stands_there_and_the_noise_decide_and_the_words_do_not():
    worlds = [World(""), *CHANGED]
    for one, other in itertools.combinations(worlds, 2):
        assert one.digest != other.digest
    for world in worlds:
        assert replace(world, about="in other words").digest == world.digest


@pytest.mark.parametrize("world", WORLDS)
def test_a_key_has_the_world_and_its_digest(world, tmp_path):
    made = RecordingKey.present(RecordingConfig(world=world))
    assert made.sha256["world"] == WORLDS[world].digest
    (tmp_path / "recording.yaml").write_bytes(made.as_yaml())
    assert RecordingKey.read(tmp_path).config.world == world


def test_a_world_that_was_changed_since_is_told_of():
    made = RecordingKey.present(RecordingConfig(world="post"))
    sha256 = {**made.sha256, "world": World("", Props(well=Well(post=Post()))).digest}
    assert made.differences(replace(made, sha256=sha256)) == ["world changed since"]


@pytest.mark.parametrize("settings", [RecordingConfig, TrainConfig, PickPlaceSettings])
def test_a_world_that_there_is_not_is_one_line_with_those_that_there_are(settings):
    with pytest.raises(InvalidChoice) as refused:
        settings(world="moon")
    assert str(refused.value) == f"world is 'moon'; valid: {', '.join(WORLDS)}"


@pytest.mark.parametrize("command", ["train", "record", "view"])
def test_the_help_of_a_command_names_every_world(command, capsys):
    with pytest.raises(SystemExit):
        app.main([command, "--help"])
    words = capsys.readouterr().out.replace("\u2502", " ").split()
    told = " ".join(words).partition("--world STR")[2]
    for world in WORLDS:
        assert world in told


def test_each_world_has_its_place_among_the_shipped_recordings(shelf):
    assert shipped.worlds() == ()
    put(shelf, "post", "post")
    put(shelf, "standard", "standard")
    assert shipped.worlds() == ("standard", "post")
    assert shipped.folder() == shelf / "standard"
    settings = PickPlaceSettings(physics="recorded", world="post")
    with pytest.warns(UserWarning, match="may differ"):
        assert load_recording(settings).key.config.world == "post"
    assert TrainConfig(world="post").recording_folder == shelf / "post"


def test_a_world_that_was_not_recorded_is_one_line_that_says_what_makes_it(shelf):
    put(shelf, "standard", "standard")
    before = content(shelf)
    expected = (
        "no recording of world post comes with the package (there are: standard); "
        "prospect record --world post --out runs/post makes one"
    )
    for ask in (
        lambda: shipped.folder("post"),
        lambda: load_recording(PickPlaceSettings(physics="recorded", world="post")),
        lambda: TrainConfig(physics="recorded", world="post").recording_folder,
    ):
        with pytest.raises(RecordingError) as refused:
            ask()
        assert str(refused.value) == expected
    assert content(shelf) == before


@pytest.mark.parametrize(("asked", "made"), [("standard", "post"), ("post", "noisy")])
def test_a_recording_of_another_world_is_refused(asked, made, tmp_path):
    put(tmp_path, "recording", made)
    folder = tmp_path / "recording"
    settings = PickPlaceSettings(physics="recorded", recording=folder, world=asked)
    with pytest.raises(RecordingError) as refused:
        load_recording(settings)
    expected = f"{folder} was recorded with world {made}, not {asked}"
    assert str(refused.value) == expected
